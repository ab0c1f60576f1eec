#pragma once

#include "core/geometry/scene.hpp"
#include "stats/resampling.hpp"

#include <array>
#include <cstdint>
#include <string_view>

namespace ff::studies {

/// The kind of obstacle between the two surfaces of an adversarial scene.
enum class Obstacle : std::uint8_t {
    plates,     ///< one to three, near one of the surfaces
    hole,       ///< a sheet with a hole in it
    near_disc,  ///< plates, one surface being a disc
};
inline constexpr std::array obstacles{Obstacle::plates, Obstacle::hole, Obstacle::near_disc};

std::string_view name(Obstacle obstacle);

/// Two faces, surfaces 0 and 1, and obstacles that belong to no face.
struct AdversarialScene {
    Scene scene;
    double exchange = 0;  ///< known exchange area of the two faces
    double exchange_error = 0;
};

/// Draws obstacles whose sizes and distances from a surface are spread over five decades, anywhere, tilted or not.
/// Every line from the far surface through an obstacle meets the near one, so that the hidden exchange is that between
/// the far surface and the obstacle, found by contour integrals (core/formulas/polygon_exchange.hpp).
AdversarialScene draw_adversarial(Obstacle obstacle, stats::Draws& draws);

}  // namespace ff::studies
