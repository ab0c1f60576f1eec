#pragma once

#include "samplers/sampler.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ff::samplers {

/// base^exponent. @pre the result is below 2^64
constexpr std::uint64_t integer_power(std::uint64_t base, std::size_t exponent) {
    std::uint64_t result = 1;
    for (std::size_t i = 0; i < exponent; ++i) result *= base;
    return result;
}

/// floor(2^64 / divisor): a fraction of the unit interval in 64-bit fixed point. @pre divisor >= 2
constexpr std::uint64_t reciprocal(std::uint64_t divisor) {
    return (~std::uint64_t{0} - (divisor - 1)) / divisor + 1;
}

/// The position `inside` (times 2^-32) cell number `cell`, in fixed point. @pre width = reciprocal(number of cells)
constexpr std::uint32_t place_in_cell(std::uint64_t cell, std::uint64_t width, std::uint32_t inside) {
    const std::uint64_t offset = inside * (width >> 32) + (inside * (width & 0xffffffffu) >> 32);
    return static_cast<std::uint32_t>((cell * width + offset) >> 32);
}

/// How many digits in `base` the last index of `points` has, at least 1. @pre base >= 2, points <= 2^32
std::uint32_t count_digits(std::uint64_t points, std::uint32_t base);

/// The largest k with k^dimension <= points. @pre points <= 2^32, dimension >= 1
std::uint64_t floor_root(std::uint64_t points, std::size_t dimension);

/// The sizes from `low` to `high` that a sampler is made for, the smallest of each octave [2^j, 2^(j+1)): powers of its
/// base for nets, k^dimension for stratified points, powers of two for samplers of any size. Empty where there is none.
/// @pre 1 <= low <= high <= max_points, info.sizes != Sizes::nodes
std::vector<std::uint64_t> size_ladder(const SamplerInfo& info, std::uint64_t low, std::uint64_t high,
                                       std::size_t dimension = max_dimension);

}  // namespace ff::samplers
