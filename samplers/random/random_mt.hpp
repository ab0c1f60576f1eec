#pragma once

#include "samplers/sampler.hpp"

namespace ff::samplers {

/// Independent uniform points from Boost.Random's mt19937_64. @see [matsumoto1998]
class RandomMt {
  public:
    static constexpr SamplerInfo info{
        .name = "random_mt",
        .summary = "independent uniform points (Mersenne twister, Boost.Random)",
        .details =
            "Plain Monte Carlo with the 64-bit Mersenne twister of Boost.Random, of period 2^19937 - 1: a second "
            "opinion on `random` from a generator of another family. Results of the two must agree within their "
            "errors.\n"
            "The twister is sequential, so every run of 1024 points has an engine of its own, seeded through a seed "
            "sequence with 256 bits that Philox makes of (key, trial, patches, run); a coordinate is the upper 32 of "
            "64 bits. Any number of points. Known trap: the twister fails tests of linear complexity over GF(2) "
            "(BigCrush), which no integral here can notice. Slower than `random`, most of all for small sets, which "
            "pay the 2.5 kB of seeding.",
        .reference = "matsumoto1998",
        .sizes = Sizes::any,
        .spread = Spread::independent,
        .nanoseconds = 15,
    };

    explicit RandomMt(const PointSetSpec& spec) : dimension_(spec.dimension) {}
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const;

  private:
    std::size_t dimension_;
};

}  // namespace ff::samplers
