#pragma once

#include "samplers/nets/sobol_directions.hpp"
#include "samplers/sampler.hpp"

#include <array>
#include <bit>

namespace ff::samplers {

/// Sobol' points with a random linear matrix scramble and a digital shift. @see [matousek1998], [owen2003],
/// [joekuo2008]
class SobolLms {
  public:
    static constexpr SamplerInfo info{
        .name = "sobol_lms",
        .summary = "Sobol' points with a random linear matrix scramble and a digital shift",
        .details =
            "The points of `sobol` before randomisation, scrambled as most libraries do it: the binary digits of each "
            "coordinate are multiplied by a random lower triangular matrix with a unit diagonal (Matousek 1998), then "
            "a random number is added digit by digit (exclusive or). Matrices and shifts are Philox words. Each point "
            "is uniform, and each pair of points is distributed as under nested uniform scrambling, so mean and "
            "variance are those of `sobol_nus` (Owen 2003); higher moments differ, and the set remains a shifted "
            "digital net.\n"
            "Sizes: powers of two; with others the set is not a net, estimates stay unbiased and lose part of their "
            "gain. "
            "The error falls as N^-3/2 (up to logarithms) for smooth integrands and as N^-5/8 or a little faster for "
            "tallies of rays. Points of one set are not independent: take intervals over trials, never within a set.",
        .reference = "matousek1998",
        .sizes = Sizes::powers,
        .spread = Spread::net,
    };

    explicit SobolLms(const PointSetSpec& /*spec*/) {}

    void fill(const Stream& stream, PointIndex first, PointBlock& block) const {
        const auto bits = static_cast<std::uint32_t>(std::bit_width(first + block.size - 1));
        const Matrices matrices = draw_matrices(stream, bits);  // direction j has digits 0 to j only
        const Words shift = philox(stream, 32, Purpose::scramble);
        for (std::size_t d = 0; d < block.dimension; ++d) {
            std::uint32_t x = shift[d];
            // From a point to the next, by the number of trailing ones of its index.
            std::array<std::uint32_t, 33> step{};
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

  private:
    /// Columns of a matrix: what digit c of a coordinate becomes, most significant first; one matrix a coordinate.
    using Matrices = std::array<Words, 32>;

    /// The first `columns` columns: the others multiply digits that no point of the block has.
    static Matrices draw_matrices(const Stream& stream, std::uint32_t columns) {
        Matrices matrices{};
        for (std::uint32_t c = 0; c < columns; ++c) {
            matrices[c] = philox(stream, c, Purpose::scramble);
            const std::uint32_t diagonal = 1u << (31 - c);
            for (std::uint32_t& column : matrices[c]) column = diagonal | (column & (diagonal - 1));
        }
        return matrices;
    }

    static std::uint32_t multiply_by_columns(const Matrices& matrices, std::size_t d, std::uint32_t digits) {
        std::uint32_t product = 0;
        for (; digits != 0; digits &= ~(0x80000000u >> std::countl_zero(digits))) {
            product ^= matrices[static_cast<std::size_t>(std::countl_zero(digits))][d];
        }
        return product;
    }
};

}  // namespace ff::samplers
