#pragma once

#include "samplers/sampler.hpp"

#include <array>

namespace ff::samplers {

/// An additive recurrence with the generalised golden ratio, randomly shifted. @see [roberts2018], [cranley1976]
class RSequence {
  public:
    static constexpr SamplerInfo info{
        .name = "r_sequence",
        .summary = "additive recurrence with the generalised golden ratio (Roberts), randomly shifted",
        .details =
            "Coordinate d of point i is the fraction of s_d + i a_d, where a_d = g^-(d+1) and g is the root of "
            "x^(D+1) = x + 1 for points of D coordinates: the golden ratio in one dimension, 1.1673... in four "
            "(Roberts 2018). The shift s is uniform (Philox); steps have 64 bits, so the last of 2^32 points is as "
            "accurate as the first.\n"
            "Any number of points, and none is better than others: the evenness is that of an irrational lattice, and "
            "not proved in more than one dimension (nobody knows whether powers of g are badly approximable together). "
            "Expect about N^-1 for smooth integrands that are periodic, less otherwise. The shift is all "
            "that is random: a trial is one of the shifts of one lattice. Points of one set are not independent: take "
            "intervals over trials.",
        .reference = "roberts2018",
        .sizes = Sizes::any,
    };

    explicit RSequence(const PointSetSpec& spec);
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const;

  private:
    std::array<std::uint64_t, max_dimension> steps_;  ///< times 2^64
};

}  // namespace ff::samplers
