#pragma once

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
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const;
};

}  // namespace ff::samplers
