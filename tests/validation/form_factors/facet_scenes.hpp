#pragma once

#include "core/geometry/fwd.hpp"

#include <cstdint>
#include <vector>

namespace ff::studies::form_factors {

/// Scenes of many facets, each a face of its own; face k is surface k.

/// A closed cube with a cube of half its size in the middle of it.
/// @param outer, inner  squares along an edge of either
Scene nested_cubes_of_facets(std::uint32_t outer, std::uint32_t inner);

/// Buildings of random height on a ground, as far apart as they are wide, open to the sky.
/// @param buildings  along a side of the city @param divisions  squares along a building's width
Scene city_of_facets(std::uint32_t buildings, std::uint32_t divisions);

/// A closed room whose floor is a square without one of its quarters.
/// @param divisions  squares along the edge of a quarter, which is as long as the room is high
Scene l_room_of_facets(std::uint32_t divisions);

/// A sphere with bumps and dents, 4 n (n - 1) triangles for n rings, in a closed cube.
/// @param divisions  squares along an edge of the cube
Scene bumpy_sphere_of_facets(std::uint32_t rings, std::uint32_t divisions);

/// One of each kind: of 216 to 540 facets, or their siblings of 48 to 133 for tests.
enum class FacetScenes { large, small };
std::vector<Scene> facet_scenes(FacetScenes sizes);

}  // namespace ff::studies::form_factors
