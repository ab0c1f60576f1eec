#pragma once

#include "core/geometry/fwd.hpp"

#include <cstdint>
#include <vector>

namespace ff::studies {

/// Two surfaces that meet in an edge or a circle where nothing else does. Each runs through it counter-clockwise, as
/// seen from the side that radiates: in opposite directions where both face the same side of what they bound.
struct Junction {
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    bool same_way = false;  ///< in the same direction: they face opposite ways
    bool certain = true;  ///< not where edges of different lengths meet at an angle: a body may stand on the longer one
};

/// Edges may differ in length, as in T-junctions, and be as far apart as rounded coordinates move them. Surfaces that
/// lie over each other do not meet.
std::vector<Junction> find_junctions(const Scene& scene);

}  // namespace ff::studies
