#pragma once

#include <cstddef>
#include <string_view>

namespace ff::stats {

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
