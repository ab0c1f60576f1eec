#pragma once

#include "samplers/sampler.hpp"

#include <cstddef>

namespace ff::samplers {

/// Faure points in base 5 with nested (Owen) scrambling. @see [faure1982], [owen1995], [owen2003], [wellons2018]
class Faure {
  public:
    static constexpr SamplerInfo info{
        .name = "faure",
        .summary = "Faure points in base 5 with nested (Owen) scrambling",
        .details =
            "The Faure sequence in base 5, the smallest prime that has four coordinates of net parameter 0: coordinate "
            "d multiplies the digits of the index by power d of the Pascal matrix modulo 5. The first point (index 0) "
            "is included. Any 5^m points that start at a multiple of 5^m form a (0, m, 4)-net: each elementary "
            "interval of volume 5^-m has exactly one; with 625 points each of the 5^4 equal cells, and every other way "
            "to cut the cube into 625 boxes along powers of five.\n"
            "Scrambling is nested: each digit is permuted by a permutation of its own for all the digits before it, "
            "drawn by a hash (lowbias32, keyed by two Philox words a coordinate) among the 20 affine ones of 120. "
            "These take any two digits to any two others equally often, which is all that mean and variance of Owen's "
            "uniform scrambling depend on (Owen 2003). Below the digits that tell the points of a set apart, and below "
            "the 13th, a coordinate is uniform (Philox).\n"
            "Sizes: powers of five: 5, 25, 125, 625, 3125, 15625, 78125, ...; with others the set is not a net, "
            "estimates stay unbiased and lose part of their gain. The error falls as N^-3/2 (up to logarithms) for "
            "smooth integrands and as N^-5/8 or a little faster for tallies of rays. Points of one set are not "
            "independent: take intervals over trials, never within a set.",
        .reference = "faure1982",
        .sizes = Sizes::powers,
        .base = 5,
        .spread = Spread::net,
        .nanoseconds = 15,
    };

    explicit Faure(const PointSetSpec& spec);
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const;

  private:
    std::size_t digits_;  ///< scrambled digits: enough to keep the points of the set distinct
};

}  // namespace ff::samplers
