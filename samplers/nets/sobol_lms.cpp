#include "samplers/nets/sobol_lms.hpp"

#include "samplers/nets/sobol_directions.hpp"

#include <bit>

namespace ff::samplers {
namespace {

/// By column (what digit c of a coordinate becomes, most significant first), for each coordinate.
using Matrices = std::array<Words, 32>;

/// The first `columns` columns: the others multiply digits that no point of the block has.
Matrices draw_matrices(const Stream& stream, std::uint32_t columns) {
    Matrices matrices{};
    for (std::uint32_t c = 0; c < columns; ++c) {
        matrices[c] = philox(stream, c, Purpose::scramble);
        const std::uint32_t diagonal = 1u << (31 - c);
        for (std::uint32_t& column : matrices[c]) column = diagonal | (column & (diagonal - 1));
    }
    return matrices;
}

std::uint32_t multiply_by_columns(const Matrices& matrices, std::size_t d, std::uint32_t digits) {
    std::uint32_t product = 0;
    for (; digits != 0; digits &= ~(0x80000000u >> std::countl_zero(digits))) {
        product ^= matrices[static_cast<std::size_t>(std::countl_zero(digits))][d];
    }
    return product;
}

}  // namespace

void SobolLms::fill(const Stream& stream, PointIndex first, PointBlock& block) const {
    const auto bits = static_cast<std::uint32_t>(std::bit_width(first + block.size - 1));
    const Matrices matrices = draw_matrices(stream, bits);  // direction j has digits 0 to j only
    const Words shift = philox(stream, 32, Purpose::scramble);
    for (std::size_t d = 0; d < block.dimension; ++d) {
        std::uint32_t x = shift[d];
        std::array<std::uint32_t, 33> step{};  // from a point to the next, by the number of trailing ones of its index
        std::uint32_t sum = 0;
        for (std::size_t j = 0; j < bits; ++j) {
            const std::uint32_t direction = multiply_by_columns(matrices, d, sobol_directions[d][j]);
            if ((first >> j & 1u) != 0) x ^= direction;
            step[j] = sum ^= direction;
        }
        for (std::size_t i = 0; i < block.size; ++i) {
            block.coordinate[d][i] = x;
            x ^= step[static_cast<std::size_t>(std::countr_one(static_cast<std::uint32_t>(first + i)))];
        }
    }
}

}  // namespace ff::samplers
