#pragma once

#include "samplers/sampler.hpp"

namespace ff::samplers {

/// Sobol' points with hash-based Owen scrambling. @see [burley2020], [owen1995], [joekuo2008], [laine2011]
class Sobol {
  public:
    static constexpr SamplerInfo info{
        .name = "sobol",
        .summary = "Sobol' points with hash-based Owen scrambling",
        .details =
            "The Sobol' sequence with the direction numbers of Joe and Kuo (new-joe-kuo-6), in natural order and with "
            "its first point (index 0) included: dropping it destroys the net and most of the gain. Any 2^m points "
            "that start at a multiple of 2^m form a (t, m, 4)-net in base 2 with t <= 3.\n"
            "Randomised by a hash in place of true nested uniform scrambling: one seeded permutation a coordinate "
            "after Laine and Karras, as proposed by Burley (2020) with the constants of Vegdahl (2021), seeded with "
            "two independent Philox words. The permutation is nested, so every net stays a net, and each point is "
            "exactly uniform, so estimates are unbiased; but 2^63 permutations stand for 2^(2^32 - 1), so theorems on "
            "the variance of nested uniform scrambling hold only as far as tests can tell.\n"
            "Sizes: powers of two; with others the set is not a net, estimates stay unbiased and lose part of their "
            "gain. The error falls as N^-3/2 (up to logarithms) for smooth integrands and as N^-5/8 or a little faster "
            "for tallies of rays. Points of one set are not independent: take intervals over trials, never within a "
            "set.",
        .reference = "burley2020",
        .sizes = Sizes::powers,
        .spread = Spread::net,
    };

    explicit Sobol(const PointSetSpec& /*spec*/) {}
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const;
};

}  // namespace ff::samplers
