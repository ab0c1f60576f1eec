#pragma once

#include "samplers/sampler.hpp"

namespace ff::samplers {

/// One uniform point in each of k^d equal cells. @see [heowen2016]
class Stratified {
  public:
    static constexpr SamplerInfo info{
        .name = "stratified",
        .summary = "one random point in each of k^4 cells (jittered)",
        .details =
            "Jittered sampling: every side of the unit cube is cut into k equal parts, and each of the k^4 cells gets "
            "one uniform point (Philox), independent of the others. The digits of the index in base k are the cell, "
            "first coordinate fastest. Cells have edges in 64-bit fixed point, so k need not divide 2^32.\n"
            "Sizes: k^4 in 4-D (k^2 in 2-D), nothing else: 256, 625, 1296, 2401, 4096, 6561, 10000, ... Never worse "
            "than `random` of the same size; the error falls as N^-5/8 for discontinuous integrands (tallies of rays) "
            "and N^-3/4 for smooth ones. A single point is uniform in its cell only, so a part of a set is no smaller "
            "set, and binomial intervals are too wide.",
        .reference = "heowen2016",
        .sizes = Sizes::fourth_power,
        .spread = Spread::grid,
    };

    explicit Stratified(const PointSetSpec& spec);
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const;

  private:
    std::uint64_t cells_a_side_;
};

}  // namespace ff::samplers
