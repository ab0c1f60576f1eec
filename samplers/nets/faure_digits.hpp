#pragma once

#include "core/points/points.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace ff::samplers {

/// The smallest prime not below the dimension: the net parameter is 0.
inline constexpr std::uint32_t faure_base = 5;

/// Digits of an index below 2^32 in the smallest base.
inline constexpr std::size_t faure_index_digits = 14;

/// Entry [j][k]: what digit k of the index (lowest first) adds to digit j of the coordinate (highest first), modulo the
/// base.
using FaureMatrix = std::array<std::array<std::uint32_t, faure_index_digits>, faure_index_digits>;

/// Power d of the Pascal matrix: binomial(k, j) d^(k - j). @see [faure1982]
constexpr FaureMatrix faure_matrix(std::uint32_t d, std::uint32_t base) {
    FaureMatrix m{};
    m[0][0] = 1;
    for (std::size_t k = 1; k < faure_index_digits; ++k) {
        for (std::size_t j = 0; j <= k; ++j) {
            m[j][k] = ((j > 0 ? m[j - 1][k - 1] : 0) + d * m[j][k - 1]) % base;
        }
    }
    return m;
}

template <std::uint32_t base>
inline constexpr std::array<FaureMatrix, max_dimension> faure_matrices{faure_matrix(0, base), faure_matrix(1, base),
                                                                       faure_matrix(2, base), faure_matrix(3, base)};

/// Digits of a coordinate of the unscrambled sequence, the most significant first.
using FaureDigits = std::array<std::uint32_t, faure_index_digits>;

template <std::uint32_t base = faure_base>
constexpr FaureDigits faure_digits(std::uint64_t index, std::size_t d) {
    FaureDigits digits{};
    for (std::size_t k = 0; index != 0; ++k, index /= base) {
        for (std::size_t j = 0; j <= k; ++j) {
            digits[j] += static_cast<std::uint32_t>(index % base) * faure_matrices<base>[d][j][k];
        }
    }
    for (std::uint32_t& digit : digits) digit %= base;
    return digits;
}

}  // namespace ff::samplers
