#pragma once

#include "samplers/sampler.hpp"

namespace ff::samplers {

/// One point in each of N slices of every coordinate, the slices paired at random. @see [mckay1979]
class LatinHypercube {
  public:
    static constexpr SamplerInfo info{
        .name = "latin_hypercube",
        .summary = "one point in each of N slices of every coordinate, paired at random",
        .details =
            "Latin hypercube sampling: every coordinate of the N points takes each of N equal slices once, in a random "
            "order of its own, at a uniform place within the slice (Philox). Sets of up to 1024 points are shuffled "
            "(Fisher and Yates); larger ones take the order from a keyed bijection of the index, so that any point can "
            "be made alone: four rounds of multiply, add and fold on the least power of two that holds the set, "
            "repeated while the result is outside. Slices have edges in 64-bit fixed point, so N need not divide "
            "2^32.\n"
            "Any number of points. What depends on one coordinate alone is integrated with an error of N^-3/2; what "
            "depends on several together, as form factors do, keeps the N^-1/2 of `random`. Variance is at most "
            "N / (N - 1) times that of `random`. A single point is uniform, but points of one set are not "
            "independent: take intervals over trials.",
        .reference = "mckay1979",
        .sizes = Sizes::any,
        .spread = Spread::latin,
        .nanoseconds = 15,
    };

    explicit LatinHypercube(const PointSetSpec& spec) : points_(spec.points) {}
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const;

  private:
    std::uint64_t points_;
};

}  // namespace ff::samplers
