#pragma once

#include "samplers/nets/sobol_directions.hpp"
#include "samplers/sampler.hpp"

namespace ff::samplers {

/// Sobol' points with true nested uniform scrambling. @see [owen1995], [joekuo2008]
class SobolNus {
  public:
    static constexpr SamplerInfo info{
        .name = "sobol_nus",
        .summary = "Sobol' points with true nested uniform scrambling (slow)",
        .details =
            "The points of `sobol` before randomisation, scrambled by the definition of Owen (1995): each node of the "
            "binary tree of digits of each coordinate has an independent random bit (Philox, addressed by the node) "
            "that swaps its halves or not. It is what the theorems on scrambled nets are about, and the reference that "
            "the hash of `sobol` is tested against: means and variances of the two must agree.\n"
            "It pays 32 Philox blocks a coordinate, some thousand times the cost of `sobol`, and is for checks and "
            "small studies. Sizes: powers of two; with others the set is not a net, estimates stay unbiased and lose "
            "part of their gain. The error falls as N^-3/2 (up to logarithms) for smooth integrands and as N^-5/8 or a "
            "little faster for tallies of rays. Points of one set are not independent: take intervals over trials, "
            "never within a set.",
        .reference = "owen1995",
        .sizes = Sizes::powers,
        .spread = Spread::net,
        .nanoseconds = 2000,
    };

    explicit SobolNus(const PointSetSpec& /*spec*/) {}

    void fill(const Stream& stream, PointIndex first, PointBlock& block) const {
        for (std::size_t d = 0; d < block.dimension; ++d) {
            for (std::size_t i = 0; i < block.size; ++i) {
                block.coordinate[d][i] =
                    scramble_coordinate(sobol_coordinate(static_cast<std::uint32_t>(first + i), d), stream, d);
            }
        }
    }

  private:
    static std::uint32_t scramble_coordinate(std::uint32_t coordinate, const Stream& stream, std::size_t dimension) {
        std::uint32_t result = 0;
        for (unsigned depth = 0; depth < 32; ++depth) {
            // A leading 1 before the digits above makes the number of a node unique over all depths.
            const std::uint32_t node = depth == 0 ? 1 : 1u << depth | coordinate >> (32 - depth);
            const std::uint32_t swap = philox(stream, node, Purpose::permutation)[dimension] >> 31;
            const std::uint32_t digit = coordinate >> (31 - depth) & 1u;
            result = result << 1 | (digit ^ swap);
        }
        return result;
    }
};

}  // namespace ff::samplers
