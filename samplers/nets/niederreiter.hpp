#pragma once

#include "samplers/sampler.hpp"

namespace ff::samplers {

/// Niederreiter points in base 2 from Boost.Random, not randomised. @see [niederreiter1988], [bratley1992]
class Niederreiter {
  public:
    static constexpr SamplerInfo info{
        .name = "niederreiter",
        .summary = "Niederreiter points in base 2 as Boost.Random gives them: not randomised, first point skipped",
        .details =
            "boost::random::niederreiter_base2: the digital sequence of Niederreiter (1988) with irreducible "
            "polynomials over GF(2) of degrees 1, 1, 2 and 3, so that t <= 3 in four dimensions, in the order of Gray "
            "code as Bratley, Fox and Niederreiter program it, and without its first point, the origin. Skipping that "
            "point destroys the net: 2^m points are a net with one point exchanged, and for smooth integrands the "
            "error falls as N^-1 only.\n"
            "Not randomised: every trial and every patch has the same points, so there is one estimate, its error is "
            "not known from it, and patches share their errors. It is here for comparison. Any number of points; no "
            "size has the whole net.",
        .reference = "niederreiter1988",
        .sizes = Sizes::any,
        .randomised = false,
        .nanoseconds = 15,
    };

    explicit Niederreiter(const PointSetSpec& /*spec*/) {}
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const;
};

}  // namespace ff::samplers
