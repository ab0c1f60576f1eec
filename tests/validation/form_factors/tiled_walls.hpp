#pragma once

#include "core/geometry/scene.hpp"
#include "stats/basics/resampling.hpp"

#include <cstdint>
#include <vector>

namespace ff::studies::form_factors {

/// An entry whose exchange area is known.
struct KnownExchange {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    double area = 0;
};

/// Relative accuracy of the exchange areas that are known.
inline constexpr double accuracy_across_walls = 1e-11;

/// A mesh in small: two parallel walls of tiles, each a face, and a plate between them that is one too.
struct TiledWalls {
    Scene scene;
    std::vector<KnownExchange> across;  ///< every tile with every one opposite
};

/// Draws the distance of the walls and a plate of any size, anywhere between them. What tiles exchange past it is
/// computed in another way than form factors are: from each place the plate's shadow on the other wall is a rectangle,
/// whose factor has a closed form; over the place Gauss's rule is exact to twelve digits between the lines where the
/// shadow's edges cross those of the tile.
/// @param n  tiles along an edge of a wall
TiledWalls draw_tiled_walls(std::size_t n, stats::Draws& draws);

}  // namespace ff::studies::form_factors
