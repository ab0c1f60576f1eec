#pragma once

#include "core/geometry/scene.hpp"
#include "stats/resampling.hpp"

#include <array>
#include <cstdint>
#include <string_view>

namespace ff::studies {

/// What stands between the two surfaces of an adversarial scene.
enum class Obstacle : std::uint8_t {
    plates,     ///< one to three, near one of the surfaces
    hole,       ///< a sheet with a hole in it
    near_disc,  ///< plates, one surface being a disc
};
inline constexpr std::array obstacles{Obstacle::plates, Obstacle::hole, Obstacle::near_disc};

std::string_view name(Obstacle obstacle);

/// Two faces, surfaces 0 and 1, and obstacles that are no faces.
struct AdversarialScene {
    Scene scene;
    double exchange = 0;  ///< between the faces: known
    double exchange_error = 0;
};

/// Draws obstacles whose sizes and distances from a surface are spread over five decades, anywhere, tilted or not. They
/// are such that every line from the far surface through an obstacle meets the near one: what it hides is then the
/// exchange between the far surface and the obstacle itself, by contour integrals (core/formulas/polygon_exchange.hpp).
AdversarialScene draw_adversarial(Obstacle obstacle, stats::Draws& draws);

}  // namespace ff::studies
