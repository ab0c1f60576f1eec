#pragma once

#include "samplers/sampler.hpp"

namespace ff::samplers {

/// Sobol' points from Boost.Random, not randomised. @see [joekuo2008], [owen2022]
class SobolRaw {
  public:
    static constexpr SamplerInfo info{
        .name = "sobol_raw",
        .summary = "Sobol' points as Boost.Random gives them: not randomised, first point skipped",
        .details =
            "What many programs use today: boost::random::sobol, with the direction numbers of Joe and Kuo, in the "
            "order of Gray code, and without its first point, the origin. Skipping that point destroys the net: 2^m "
            "points are a net with one point exchanged, and for smooth integrands the error falls as N^-1 where the "
            "whole net, randomised, has N^-3/2 (Owen 2022). Tallies of rays hardly notice.\n"
            "Not randomised: every trial and every patch has the same points, so there is one estimate, its error is "
            "not known from it, and patches share their errors. It is here for comparison; `sobol` is the one to use. "
            "Any number of points; no size has the whole net.",
        .reference = "joekuo2008",
        .sizes = Sizes::any,
        .randomised = false,
        .nanoseconds = 15,
    };

    explicit SobolRaw(const PointSetSpec& /*spec*/) {}
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const;
};

}  // namespace ff::samplers
