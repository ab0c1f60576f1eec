#pragma once

#include "samplers/point_sets/point_set.hpp"

#include <cstdint>
#include <optional>

namespace ff::studies {

/// Measures of the evenness of a point set: the smaller, the more even.
struct EvennessOfSet {
    std::optional<std::uint32_t> t_value;       ///< empty unless the number of points is a small power of the base
    std::optional<double> l2_star_discrepancy;  ///< empty for more than `most_quadratic` points
    std::optional<double> centred_discrepancy;  ///< likewise
    double largest_gap = 0;                     ///< on any axis
};

inline constexpr std::uint64_t most_quadratic = 1u << 14;
inline constexpr std::uint64_t most_for_t_value = 1u << 16;

/// @param base  of the t-value
EvennessOfSet evenness_of(const samplers::PointSet& set, std::uint32_t base);

}  // namespace ff::studies
