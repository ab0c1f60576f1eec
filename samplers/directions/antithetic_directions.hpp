#pragma once

#include "samplers/random/antithetic.hpp"

namespace ff::samplers {

/// Pairs of rays from one origin with directions on opposite sides of the normal. @see [hammersley1956]
class AntitheticDirections {
  public:
    static constexpr SamplerInfo info{
        .name = "antithetic_directions",
        .summary = "random points in pairs: the same origin and elevation, opposite azimuths",
        .details =
            "Points 2k and 2k + 1 are point k of `random`, and the same with half a turn added to the last coordinate, "
            "which is the azimuth of rays: both start at one place and leave on opposite sides of the normal. What "
            "lies to one side is hit by one of them at most. `antithetic` mirrors all coordinates instead.\n"
            "Any number of points; with an odd one the last has no partner. The error falls as N^-1/2. The two of a "
            "pair are not independent: take intervals over trials, never within a set.",
        .reference = "hammersley1956",
        .sizes = Sizes::any,
        .spread = Spread::mirrored,
    };

    explicit AntitheticDirections(const PointSetSpec& spec) : random_(spec) {}

    void fill(const Stream& stream, PointIndex first, PointBlock& block) const {
        constexpr std::uint32_t half_turn = 1u << 31;
        const std::size_t azimuth = block.dimension - 1;
        fill_in_pairs(random_, stream, first, block,
                      [azimuth](std::size_t d, std::uint32_t x) { return d == azimuth ? x + half_turn : x; });
    }

  private:
    Random random_;
};

}  // namespace ff::samplers
