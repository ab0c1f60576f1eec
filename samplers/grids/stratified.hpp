#pragma once

#include "samplers/sampler.hpp"
#include "samplers/support/philox_block.hpp"
#include "samplers/support/sizes.hpp"

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

    explicit Stratified(const PointSetSpec& spec) : cells_a_side_(floor_root(spec.points, spec.dimension)) {}

    void fill(const Stream& stream, PointIndex first, PointBlock& block) const {
        philox_block(stream, Purpose::coordinates, first, block);
        if (cells_a_side_ == 1) return;
        const std::uint64_t width = reciprocal(cells_a_side_);  // width of a cell, times 2^64
        std::uint64_t repeats = 1;                              // consecutive points with the same digit d
        for (std::size_t d = 0; d < block.dimension; ++d) {
            std::uint64_t cell = first / repeats % cells_a_side_;
            std::uint64_t left = repeats - first % repeats;
            for (std::size_t i = 0; i < block.size; ++i) {
                std::uint32_t& x = block.coordinate[d][i];
                x = place_in_cell(cell, width, x);
                if (--left == 0) {
                    left = repeats;
                    if (++cell == cells_a_side_) cell = 0;
                }
            }
            repeats *= cells_a_side_;
        }
    }

  private:
    std::uint64_t cells_a_side_;
};

}  // namespace ff::samplers
