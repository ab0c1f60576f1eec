#pragma once

#include "samplers/sequences/halton.hpp"
#include "samplers/support/sizes.hpp"

#include <algorithm>

namespace ff::samplers {

/// Hammersley's points: i / n beside radical inverses, randomised. @see [hammersley1960]
class Hammersley {
  public:
    static constexpr SamplerInfo info{
        .name = "hammersley",
        .summary = "Hammersley points: i/n and radical inverses in bases 2, 3, 5 with random digit permutations",
        .details =
            "The last two coordinates of point i, a ray's direction, are i/n, shifted by one random number for all "
            "points (modulo 1), and the radical inverse of i in base 2; the first two, its origin, those in bases 3 "
            "and 5. Digits are permuted as those of `halton`.\n"
            "Any number of points, but the first ones of a set are no smaller set: n has to be known. Its discrepancy "
            "is that of Halton points with one coordinate less. Points of one set are not independent: take intervals "
            "over trials.",
        .reference = "hammersley1960",
        .sizes = Sizes::any,
        .spread = Spread::halton,
        .nanoseconds = 13,
    };

    explicit Hammersley(const PointSetSpec& spec) : points_(spec.points), halton_(spec) {}

    void fill(const Stream& stream, PointIndex first, PointBlock& block) const {
        const std::size_t grid = block.dimension < 2 ? 0 : block.dimension - 2;
        if (block.dimension > 1) {
            PointBlock inverses;
            inverses.dimension = block.dimension - 1;
            inverses.size = block.size;
            halton_.fill(stream, first, inverses);
            for (std::size_t d = 0; d < inverses.dimension; ++d) {
                const std::size_t to = d == 0 ? block.dimension - 1 : d - 1;
                std::copy_n(inverses.coordinate[d].begin(), block.size, block.coordinate[to].begin());
            }
        }
        const Words shift = philox(stream, 0, Purpose::scramble);
        const std::uint64_t step = points_ < 2 ? 0 : reciprocal(points_);
        std::uint64_t x = (std::uint64_t{shift[0]} << 32 | shift[1]) + first * step;  // modulo 1
        for (std::size_t i = 0; i < block.size; ++i, x += step)
            block.coordinate[grid][i] = static_cast<std::uint32_t>(x >> 32);
    }

  private:
    std::uint64_t points_;
    Halton halton_;
};

}  // namespace ff::samplers
