#pragma once

#include "samplers/sequences/halton.hpp"

namespace ff::samplers {

/// Hammersley's points: i / n beside radical inverses, randomised. @see [hammersley1960]
class Hammersley {
  public:
    static constexpr SamplerInfo info{
        .name = "hammersley",
        .summary = "Hammersley points: i/n and radical inverses in bases 2, 3, 5 with random digit permutations",
        .details =
            "The last two coordinates of point i, a ray's direction, are i/n, shifted by one random number for all "
            "points (modulo 1), and the radical inverse of i in base 2; the first two, its origin, those in bases 3 "
            "and 5. Digits are permuted as those of `halton`.\n"
            "Any number of points, but the first ones of a set are no smaller set: n has to be known. Its discrepancy "
            "is that of Halton points with one coordinate less. Points of one set are not independent: take intervals "
            "over trials.",
        .reference = "hammersley1960",
        .sizes = Sizes::any,
        .spread = Spread::halton,
        .nanoseconds = 13,
    };

    explicit Hammersley(const PointSetSpec& spec) : points_(spec.points), halton_(spec) {}
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const;

  private:
    std::uint64_t points_;
    Halton halton_;
};

}  // namespace ff::samplers
