#pragma once

#include "core/points/points.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace ff::samplers {

/// Column j of each matrix is xored into the coordinate (most significant bit first) if bit j of the index is set.
using SobolDirections = std::array<std::array<std::uint32_t, 32>, max_dimension>;

namespace detail {

/// One line of the table new-joe-kuo-6.21201: degree s and inner coefficients a of the primitive polynomial, and the
/// initial direction numbers m_1 .. m_s.
struct JoeKuo {
    std::size_t degree;
    std::uint32_t coefficients;
    std::array<std::uint32_t, 3> initial;
};

constexpr std::array<std::uint32_t, 32> directions(const JoeKuo& line) {
    std::array<std::uint32_t, 32> v{};
    for (std::size_t j = 0; j < v.size(); ++j) {
        if (j < line.degree) {
            v[j] = line.initial[j] << (31 - j);
            continue;
        }
        v[j] = v[j - line.degree] ^ v[j - line.degree] >> line.degree;
        for (std::size_t k = 1; k < line.degree; ++k) {
            if ((line.coefficients >> (line.degree - 1 - k) & 1u) != 0) v[j] ^= v[j - k];
        }
    }
    return v;
}

constexpr std::array<std::uint32_t, 32> van_der_corput() {
    std::array<std::uint32_t, 32> v{};
    for (std::size_t j = 0; j < v.size(); ++j) v[j] = 1u << (31 - j);
    return v;
}

}  // namespace detail

/// Sobol' direction numbers of Joe and Kuo, the first four dimensions. @see [joekuo2008]
inline constexpr SobolDirections sobol_directions{
    detail::van_der_corput(),
    detail::directions({.degree = 1, .coefficients = 0, .initial = {1}}),
    detail::directions({.degree = 2, .coefficients = 1, .initial = {1, 3}}),
    detail::directions({.degree = 3, .coefficients = 1, .initial = {1, 3, 1}}),
};

/// Coordinate `d` of unscrambled point `index` in natural (not Gray code) order, times 2^32.
constexpr std::uint32_t sobol_coordinate(std::uint32_t index, std::size_t d) {
    std::uint32_t x = 0;
    for (std::size_t j = 0; j < 32; ++j) {
        if ((index >> j & 1u) != 0) x ^= sobol_directions[d][j];
    }
    return x;
}

}  // namespace ff::samplers
