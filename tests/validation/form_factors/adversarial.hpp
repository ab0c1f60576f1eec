#pragma once

#include "core/geometry/fwd.hpp"
#include "stats/basics/resampling.hpp"
#include "tests/validation/form_factors/tiled_walls.hpp"

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace ff::studies::form_factors {

/// The kinds of adversarial scenes.
enum class Trap : std::uint8_t {
    plates,      ///< one to three, near one of two rectangles
    hole,        ///< a sheet with a hole in it
    near_disc,   ///< plates, one surface being a disc
    ball,        ///< a sphere, near one of two rectangles
    many_faces,  ///< plates, one surface being divided into 600 faces
    room,        ///< a closed box with a plate near its floor
};
inline constexpr std::array traps{Trap::plates, Trap::hole, Trap::near_disc, Trap::ball, Trap::many_faces, Trap::room};

std::string_view name(Trap trap);

/// A scene some of whose entries are known.
struct AdversarialScene {
    Scene scene;
    std::vector<KnownExchange> known;
    double error = 0;  ///< bound of the error of all of these
};

/// Draws obstacles whose sizes and distances from a surface are spread over five decades, anywhere, tilted or not.
/// Every line from the far surface through an obstacle meets the near one, so that the hidden exchange is that between
/// the far surface and the obstacle, found by contour integrals (core/formulas/polygon_exchange.hpp), or for a sphere
/// by Gauss's rule over the far surface. The sizes of half of all scenes vary over twelve decades, and a quarter lie up
/// to a million times their size from the origin.
AdversarialScene draw_adversarial(Trap trap, stats::Draws& draws);

}  // namespace ff::studies::form_factors
