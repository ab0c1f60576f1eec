#pragma once

#include "samplers/point_sets/point_set.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace ff::samplers {

/// The smallest t for which a set of base^m points is a (t, m, s)-net: every elementary interval of volume base^(t - m)
/// holds base^t points [niederreiter1992]. 0 is best; t = m means no structure. Points on the boundary of an interval
/// are sorted as by `readings`. Empty where the number of points is not a power of the base. @pre set < points.sets
std::optional<std::uint32_t> net_parameter(const PointSet& points, std::uint64_t set, std::uint32_t base);

/// An elementary interval: of coordinate d, number `number[d]`, from 0, of base^digits[d] parts.
struct ElementaryInterval {
    std::array<std::uint32_t, max_dimension> digits{};
    std::array<std::uint64_t, max_dimension> number{};
    std::uint64_t points = 0;  ///< number of points that it holds
};

/// An elementary interval of volume base^(t - m) that holds more than base^t of the base^m points; empty where one of
/// the `readings` has none, so that the set is a (t, m, s)-net. @pre the number of points is base^m, t <= m, set <
/// points.sets
std::optional<ElementaryInterval> crowded_interval(const PointSet& points, std::uint64_t set, std::uint32_t base,
                                                   std::uint32_t t);

}  // namespace ff::samplers
