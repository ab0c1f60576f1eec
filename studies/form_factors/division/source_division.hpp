#pragma once

#include "core/formulas/edge_integral.hpp"
#include "core/geometry/scene.hpp"
#include "core/visibility/blocker.hpp"
#include "studies/form_factors/division/source_cells.hpp"

#include <optional>
#include <vector>

namespace ff::studies::form_factors {

/// Divides a surface by what its parts see of another.
/// @param source    any surface; nothing is proved about parts of a curved one
/// @param target    a polygon, like all blockers
/// @param whole     unoccluded exchange area, where it determines the number of points (PointEffort)
/// @param wanted    relevant exchange area
SourceCells divide(const Surface& source, const Surface& target, const std::vector<Blocker>& blockers,
                   const std::optional<BoundedValue<double>>& whole, double wanted);

}  // namespace ff::studies::form_factors
