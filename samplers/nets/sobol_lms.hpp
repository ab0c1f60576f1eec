#pragma once

#include "samplers/sampler.hpp"

namespace ff::samplers {

/// Sobol' points with a random linear matrix scramble and a digital shift. @see [matousek1998], [owen2003],
/// [joekuo2008]
class SobolLms {
  public:
    static constexpr SamplerInfo info{
        .name = "sobol_lms",
        .summary = "Sobol' points with a random linear matrix scramble and a digital shift",
        .details =
            "The points of `sobol` before randomisation, scrambled as most libraries do it: the binary digits of each "
            "coordinate are multiplied by a random lower triangular matrix with a unit diagonal (Matousek 1998), then "
            "a random number is added digit by digit (exclusive or). Matrices and shifts are Philox words. Each point "
            "is uniform, and each pair of points is distributed as under nested uniform scrambling, so mean and "
            "variance are those of `sobol_nus` (Owen 2003); higher moments differ, and the set remains a shifted "
            "digital net.\n"
            "Sizes: powers of two; with others the set is not a net, estimates stay unbiased and lose part of their "
            "gain. "
            "The error falls as N^-3/2 (up to logarithms) for smooth integrands and as N^-5/8 or a little faster for "
            "tallies of rays. Points of one set are not independent: take intervals over trials, never within a set.",
        .reference = "matousek1998",
        .sizes = Sizes::powers,
        .spread = Spread::net,
    };

    explicit SobolLms(const PointSetSpec& /*spec*/) {}
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const;
};

}  // namespace ff::samplers
