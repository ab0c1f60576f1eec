#pragma once

#include "samplers/sampler.hpp"

#include <array>

namespace ff::samplers {

/// The Halton sequence in bases 2, 3, 5, 7 with random digit permutations. @see [halton1960], [owen2017]
class Halton {
  public:
    static constexpr SamplerInfo info{
        .name = "halton",
        .summary = "Halton points in bases 2, 3, 5, 7 with random digit permutations",
        .details =
            "Coordinate d of point i is the radical inverse of i in base 2, 3, 5 or 7. Each digit position has an "
            "independent, uniformly random permutation of the digits (Owen 2017), the same for all points: not nested "
            "scrambling, in which it would depend on the digits before. The endless leading zeros of an index are "
            "permuted as well; together they are one uniform number, and as such they are drawn, so that each "
            "coordinate is uniform to 2^-32.\n"
            "Any number of points; the first b^k points from a multiple of b^k on have one point in each interval of "
            "length b^-k. Measured on tallies of rays the error falls as N^-0.66, on smooth integrands as N^-1. Known "
            "trap, met by the scrambling: without it, neighbouring bases of high dimensions are correlated. Points of "
            "one set are not independent: take intervals over trials.",
        .reference = "owen2017",
        .sizes = Sizes::any,
        .spread = Spread::halton,
        .nanoseconds = 15,
    };

    explicit Halton(const PointSetSpec& spec);
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const;

  private:
    std::array<std::uint32_t, max_dimension> digits_{};  ///< digits of an index of the set, by coordinate
};

}  // namespace ff::samplers
