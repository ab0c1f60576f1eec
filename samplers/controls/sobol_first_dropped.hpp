#pragma once

#include "samplers/nets/sobol.hpp"

namespace ff::samplers {

/// Control: `sobol` without its first point. @see [owen2022]
class SobolFirstDropped {
  public:
    static constexpr SamplerInfo info{
        .name = "sobol_first_dropped",
        .summary = "sobol without its first point: no net, noisier on smooth integrands",
        .details =
            "Points 1 .. N of the scrambled sequence instead of 0 .. N - 1, as libraries do that take the first point, "
            "the origin, for a nuisance. Every point is still uniform, so nothing is biased; but 2^m points that do "
            "not begin at a multiple of 2^m are not a net, and one point in the wrong place costs 1/N where the error "
            "of the net falls faster than that (Owen 2022). Tallies of rays hardly notice.\n"
            "Caught by: a gate on the standard deviation, or on the slope, of a smooth estimate.",
        .reference = "owen2022",
        .sizes = Sizes::powers,
        .control = true,
        .unbroken_name = "sobol",
    };

    explicit SobolFirstDropped(const PointSetSpec& spec) : sobol_(spec) {}
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const {
        sobol_.fill(stream, first + 1, block);
    }

  private:
    Sobol sobol_;
};

}  // namespace ff::samplers
