#pragma once

#include "samplers/sampler.hpp"

#include <array>

namespace ff::samplers {

/// An additive recurrence with the generalised golden ratio, randomly shifted. @see [roberts2018], [cranley1976]
class RSequence {
  public:
    static constexpr SamplerInfo info{
        .name = "r_sequence",
        .summary = "additive recurrence with the generalised golden ratio (Roberts), randomly shifted",
        .details =
            "Coordinate d of point i is the fraction of s_d + i a_d, where a_d = g^-(d+1) and g is the root of "
            "x^(D+1) = x + 1 for points of D coordinates: the golden ratio in one dimension, 1.1673... in four "
            "(Roberts 2018). The shift s is uniform (Philox); steps have 64 bits, so the last of 2^32 points is as "
            "accurate as the first.\n"
            "Any number of points, and none is better than others: the evenness is that of an irrational lattice, and "
            "not proved in more than one dimension (nobody knows whether powers of g are badly approximable together). "
            "Expect about N^-1 for smooth integrands that are periodic, less otherwise. The shift is all "
            "that is random: a trial is one of the shifts of one lattice. Points of one set are not independent: take "
            "intervals over trials.",
        .reference = "roberts2018",
        .sizes = Sizes::any,
    };

    explicit RSequence(const PointSetSpec& spec) : steps_(golden_steps[spec.dimension - 1]) {}

    void fill(const Stream& stream, PointIndex first, PointBlock& block) const {
        const Words high = philox(stream, 0, Purpose::scramble);
        const Words low = philox(stream, 1, Purpose::scramble);
        for (std::size_t d = 0; d < block.dimension; ++d) {
            std::uint64_t x = (std::uint64_t{high[d]} << 32 | low[d]) + first * steps_[d];
            for (std::size_t i = 0; i < block.size; ++i, x += steps_[d]) {
                block.coordinate[d][i] = static_cast<std::uint32_t>(x >> 32);
            }
        }
    }

  private:
    /// Powers g^-1 to g^-D times 2^64, rounded down, for points of D = 1 to 4 coordinates. Made with
    /// python3: for D in 1..4 bisect g in x^(D+1) = x + 1 as an integer times 2^200, then (1 << 64 + 200 d) // g**d.
    static constexpr std::array<std::array<std::uint64_t, max_dimension>, max_dimension> golden_steps{{
        {0x9e3779b97f4a7c15},
        {0xc13fa9a902a6328f, 0x91e10da5c79e7b1c},
        {0xd1b54a32d192ed03, 0xabc98388fb8fac02, 0x8cb92ba72f3d8dd7},
        {0xdb4f0b9175ae2165, 0xbbe0563303a4615f, 0xa0f2ec75a1fe1575, 0x89e182857d9ed688},
    }};

    std::array<std::uint64_t, max_dimension> steps_;  ///< times 2^64
};

}  // namespace ff::samplers
