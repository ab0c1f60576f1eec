#include "samplers/grids/stratified.hpp"

#include "samplers/support/philox_block.hpp"
#include "samplers/support/sizes.hpp"

namespace ff::samplers {

Stratified::Stratified(const PointSetSpec& spec) : cells_a_side_(floor_root(spec.points, spec.dimension)) {}

void Stratified::fill(const Stream& stream, PointIndex first, PointBlock& block) const {
    philox_block(stream, Purpose::coordinates, first, block);
    if (cells_a_side_ == 1) return;
    const std::uint64_t width = reciprocal(cells_a_side_);  // of a cell, times 2^64
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

}  // namespace ff::samplers
