#pragma once

#include "samplers/random.hpp"

namespace ff::samplers {

/// `random` in pairs: each point is followed by its mirror image. @see [hammersley1956]
class Antithetic {
  public:
    static constexpr SamplerInfo info{
        .name = "antithetic",
        .summary = "independent uniform points, each followed by its mirror image",
        .details =
            "Antithetic variates: points 2k and 2k + 1 are point k of `random` and its reflection in the centre of the "
            "cube, u and 1 - u. An integrand that is odd about the centre is integrated exactly by every pair; one "
            "that is even costs twice as much as with `random`; the variance is between 0 and twice that of `random`, "
            "and the error falls as N^-1/2 all the same.\n"
            "Any number of points; with an odd one the last point has no partner. A single point is uniform, but the "
            "two of a pair are not independent, so binomial intervals do not hold within a set: take intervals over "
            "trials.",
        .reference = "hammersley1956",
        .sizes = Sizes::any,
    };

    explicit Antithetic(const PointSetSpec& spec) : random_(spec) {}
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const;

  private:
    Random random_;
};

}  // namespace ff::samplers
