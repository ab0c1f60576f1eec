#pragma once

#include "core/geometry/fwd.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace ff {

/// The surfaces on slanting planes of which a body may cover a part, if coordinates were rounded to the scene's
/// coordinate_step: a body that standing_bodies finds with that much slack. None where there is no such step.
std::vector<std::uint32_t> grounds_in_doubt(const Scene& scene);

/// Round surfaces that end on a flat one which they cover a part of, by their indices: the round one, and the flat one.
/// What they cover is not left out of it, as it is for bodies of polygons.
std::vector<std::pair<std::uint32_t, std::uint32_t>> round_bodies_on_surfaces(const Scene& scene);

}  // namespace ff
