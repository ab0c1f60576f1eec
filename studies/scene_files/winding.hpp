#pragma once

#include "core/geometry/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ff::studies {

/// Surfaces of a face that face the other way than the rest of it, for example because some of its triangles are wound
/// the other way: then neighbours run through their common edge in the same direction.
struct Winding {
    std::vector<std::size_t>
        turned;  ///< surfaces to reverse, so that all of each connected part of a face faces the same way
    std::vector<int> undecided;  ///< faces half of whose area faces either way, so that nothing decides which is right
};

/// Among polygons that are joined by edges which exactly two of them share, those with the smaller total area are
/// turned; where the areas are equal, those that see more of other faces once they are turned.
Winding find_winding(const Scene& scene);

/// Two faces that run through a common edge in the same direction: one of them may face the wrong way.
std::vector<std::pair<int, int>> faces_wound_differently(const Scene& scene);

}  // namespace ff::studies
