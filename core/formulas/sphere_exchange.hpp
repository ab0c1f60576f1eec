#pragma once

#include "core/formulas/polygon_exchange.hpp"
#include "core/geometry/fwd.hpp"

#include <optional>

namespace ff {

/// Exchange area A_1 F_12, in squared units of length, of the outside of a whole sphere and a flat surface or the
/// inside of a wall or a zone. Where it lies wholly in front of all tangent planes of a surface, a sphere acts there as
/// a source at its centre would: the exchange area is its squared radius times the solid angle of the surface as seen
/// from the centre, which is an integral along its rims (core/formulas/circle_rule.hpp). Callers have to know that
/// nothing else stands in between.
/// @param wanted  largest error that is good enough
/// @return empty for other shapes, for a sphere that reaches behind a tangent plane, and where its centre is so close
/// to a rim that the rule would need too many nodes; the error bounds the truncation and estimates the rounding
std::optional<BoundedValue<double>> sphere_exchange_area(const Surface& from, const Surface& to, double wanted);

}  // namespace ff
