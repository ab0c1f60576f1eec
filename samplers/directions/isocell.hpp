#pragma once

#include "samplers/sampler.hpp"
#include "samplers/support/philox_block.hpp"
#include "samplers/support/sizes.hpp"

#include <cmath>

namespace ff::samplers {

/// One point in each of 3 k^2 cells of a disc that have the same area and nearly the same shape. @see [jacques2015]
class Isocell {
  public:
    static constexpr SamplerInfo info{
        .name = "isocell",
        .summary = "one direction in each of 3 k^2 isocells of the disc, each from a random origin",
        .details =
            "The disc that cosine-distributed directions project to is cut into k rings of equal width, ring j into "
            "3 (2 j - 1) cells: all 3 k^2 have the same area and are about as long as wide (Masset, Bruels and "
            "Kerschen). The last two coordinates of point i, squared sine and azimuth, lie in cell i + a random "
            "offset, uniformly; the first two, the origin, are independent and uniform: one ray for each surface "
            "point, what Jacques, Masset and Kerschen call global isocell, with random places in the cells where they "
            "take the middles, so that it is unbiased.\n"
            "Sizes: 3 k^2, as 48, 108, 192, 300, 432, 588, 768; of any other number those beyond the largest are "
            "random. Only what depends on the direction gains: with rays that start anywhere the error falls as "
            "N^-1/2.",
        .reference = "jacques2015",
        .sizes = Sizes::any,
        .spread = Spread::other,
        .nanoseconds = 12,
    };

    explicit Isocell(const PointSetSpec& spec) : points_(spec.points), rings_(floor_root(spec.points / 3, 2)) {}

    void fill(const Stream& stream, PointIndex first, PointBlock& block) const {
        philox_block(stream, Purpose::coordinates, first, block);
        if (block.dimension < 2) return;
        auto& squared_sine = block.coordinate[block.dimension - 2];
        auto& azimuth = block.coordinate[block.dimension - 1];
        const std::uint64_t offset = philox(stream, 0, Purpose::scramble)[0] * points_ >> 32;
        for (std::size_t i = 0; i < block.size; ++i) {
            const std::uint64_t cell = (first + i + offset) % points_;
            if (cell >= 3 * rings_ * rings_) continue;  // a point outside all rings stays random
            const std::uint64_t ring = ring_of(cell);
            const std::uint64_t cells = 3 * (2 * ring + 1);
            squared_sine[i] = share(ring * ring, static_cast<double>(2 * ring + 1) * squared_sine[i], rings_ * rings_);
            azimuth[i] = share(cell - 3 * ring * ring, azimuth[i], cells);
        }
    }

  private:
    /// The first ring, from 0, up to which there are more cells than `cell`.
    static std::uint64_t ring_of(std::uint64_t cell) {
        auto ring = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(cell) / 3));
        while (3 * (ring + 1) * (ring + 1) <= cell) ++ring;
        while (3 * ring * ring > cell) --ring;
        return ring;
    }

    /// `whole` and a fraction times 2^-32, as a share of `all`, in fixed point. @pre below 1
    static std::uint32_t share(std::uint64_t whole, double fraction, std::uint64_t all) {
        return static_cast<std::uint32_t>((static_cast<double>(whole) + fraction * 0x1p-32) / static_cast<double>(all) *
                                          0x1p32);
    }

    std::uint64_t points_;
    std::uint64_t rings_;
};

}  // namespace ff::samplers
