#pragma once

#include "samplers/sampler.hpp"
#include "samplers/support/philox_block.hpp"

namespace ff::samplers {

/// Independent uniform points: one Philox4x32-10 block per point. @see [salmon2011]
class Random {
  public:
    static constexpr SamplerInfo info{
        .name = "random",
        .summary = "independent uniform points (Philox4x32-10)",
        .details =
            "Plain Monte Carlo, and the yardstick for every other sampler. Point i is the four words that the "
            "counter-based generator Philox4x32-10 makes of (key, trial, patches, i), with 32 bits a coordinate; it "
            "passes BigCrush, and nothing has to be seeded or skipped.\n"
            "Any number of points. The error falls as N^-1/2 whatever the integrand, provided that its variance is "
            "finite; points are independent, so binomial intervals hold within one set. Differences below 2^-32 are "
            "not seen: from some 10^9 points on, the resolution shows.",
        .reference = "salmon2011",
        .sizes = Sizes::any,
        .spread = Spread::independent,
    };

    explicit Random(const PointSetSpec& /*spec*/) {}

    void fill(const Stream& stream, PointIndex first, PointBlock& block) const {
        philox_block(stream, Purpose::coordinates, first, block);
    }
};

}  // namespace ff::samplers
