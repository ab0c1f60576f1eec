#pragma once

#include "core/support/contract.hpp"

#include <cmath>
#include <cstddef>
#include <string_view>

namespace ff::stats {

/// The highest level that may be requested. Even shared among all tests of a study, 1 - level stays far above
/// rounding.
inline constexpr double largest_level = 1 - 1e-9;

/// Whether a level lies strictly between 0.5 and 1, up to the highest level. False for NaN.
constexpr bool is_level(double level) {
    return level > 0.5 && level <= largest_level;
}

/// Fewest replicates for an interval based on their spread [lecuyer2023]; fewer are not judged.
inline constexpr std::size_t fewest_replicates = 5;

/// A confidence interval with its origin.
struct Interval {
    double low = 0;
    double high = 0;
    double level = 0;         ///< nominal coverage in (0, 1)
    std::string_view method;  ///< "student_t", "chi_squared", "clopper_pearson", ...; a string literal
    std::size_t n = 0;        ///< independent observations behind it

    [[nodiscard]] bool contains(double value) const { return low <= value && value <= high; }
    [[nodiscard]] double width() const { return high - low; }
    [[nodiscard]] Interval shifted(double by) const { return {low + by, high + by, level, method, n}; }
    /// An infinite end tells that the observations prove nothing on that side.
    [[nodiscard]] bool is_finite() const { return std::isfinite(low) && std::isfinite(high); }
};

/// centre -+ half.
inline Interval interval_around(double centre, double half, double level, std::string_view method, std::size_t n) {
    return {.low = centre - half, .high = centre + half, .level = level, .method = method, .n = n};
}

/// Interval of the square root of a nonnegative quantity, e.g. of sigma from that of the variance.
inline Interval square_root(Interval interval) {
    FF_EXPECT(interval.low >= 0);
    interval.low = std::sqrt(interval.low);
    interval.high = std::sqrt(interval.high);
    return interval;
}

}  // namespace ff::stats
