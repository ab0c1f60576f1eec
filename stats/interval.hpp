#pragma once

#include <cstddef>
#include <string_view>

namespace ff::stats {

/// The highest level that may be asked for. Shared among the tests of a study what remains is still far above the
/// rounding of 1 - level.
inline constexpr double largest_level = 1 - 1e-9;

/// Whether intervals of this level are right more often than not, but not always. False for NaN.
constexpr bool is_level(double level) {
    return level > 0.5 && level <= largest_level;
}

/// Replicates from which an interval by their spread holds its level well [lecuyer2023]; with fewer nothing is judged.
inline constexpr std::size_t fewest_replicates = 5;

/// A confidence interval that says where it comes from.
struct Interval {
    double low = 0;
    double high = 0;
    double level = 0;         ///< nominal coverage in (0, 1)
    std::string_view method;  ///< "student_t", "chi_squared", "clopper_pearson", ...; a literal, valid for ever
    std::size_t n = 0;        ///< independent observations behind it

    [[nodiscard]] bool contains(double value) const { return low <= value && value <= high; }
    [[nodiscard]] double width() const { return high - low; }
};

/// Interval of the square root of a quantity that is nowhere negative, e.g. of sigma from that of the variance.
Interval square_root(const Interval& interval);

}  // namespace ff::stats
