#pragma once

#include "samplers/point_set.hpp"

#include <cstdint>
#include <optional>

namespace ff::studies {

/// How evenly the points of a set are spread: the smaller, the more so.
struct EvennessOfSet {
    std::optional<std::uint32_t> t_value;       ///< empty where the number of points is no power of the base, or large
    std::optional<double> l2_star_discrepancy;  ///< empty for more than `most_quadratic` points
    std::optional<double> centred_discrepancy;  ///< likewise
    double largest_gap = 0;                     ///< of an axis
};

inline constexpr std::uint64_t most_quadratic = 1u << 14;
inline constexpr std::uint64_t most_for_t_value = 1u << 16;

/// @param base  of the t-value
EvennessOfSet evenness_of(const samplers::PointSet& set, std::uint32_t base);

}  // namespace ff::studies
