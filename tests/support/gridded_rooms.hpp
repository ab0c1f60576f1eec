#pragma once

#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"

#include <array>
#include <cstddef>

namespace ff::test {

/// The inside of a box of 4 x 1 x 2 that is not an `empty_box`, so that nothing is traced or unfolded by special rules
/// for one. Every face has a grid of its own, with different numbers of columns and rows where they could be confused.
inline Scene gridded_room() {
    Scene room = make_box(4, 1, 2);
    room.empty_box.reset();
    room.canonical = "gridded room";
    constexpr std::array<Grid, 6> grids{{{4, 1}, {2, 3}, {1, 1}, {1, 2}, {3, 1}, {2, 2}}};
    for (std::size_t i = 0; i < grids.size(); ++i) room.surfaces[i].grid = grids.at(i);
    return room;
}

/// The same, with a face 1 of two unequal surfaces: [0, 1] and [1, 4] along its length, with 2 and 3 parts.
inline Scene room_with_divided_floor() {
    Scene room = gridded_room();
    room.canonical = "room with divided floor";
    Surface rest = room.surfaces[0];
    parallelogram(room.surfaces[0]).edge_u /= 4;
    room.surfaces[0].grid = {1, 2};
    parallelogram(rest).corner += parallelogram(room.surfaces[0]).edge_u;
    parallelogram(rest).edge_u *= 0.75;
    rest.grid = {3, 1};
    room.surfaces.push_back(rest);
    return room;
}

}  // namespace ff::test
