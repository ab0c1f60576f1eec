#pragma once

// Shared by stats/skewed_mean.hpp and by stats/gate.hpp: C++17, the standard library alone.

#include <algorithm>
#include <cmath>
#include <iterator>

namespace ff::gate {

/// How far the limits of a mean lie from it, in standard errors, where values may be skewed: Student's t, corrected for
/// the sample's skewness plus three of its standard errors [hall1992], [johnson1978]. An open limit means that the
/// sample is too skewed, or too small, for so small a tail.
struct SkewedReach {
    double below = 0;
    double above = 0;
    bool below_is_open = false;
    bool above_is_open = false;
};

/// The estimated skewness of values.
struct Skewness {
    double value = 0;
    double error = 0;         ///< standard error, at least that for normal values
    double normal_error = 0;  ///< for normal values
};

/// @param values  at least 3, not all equal    @param effective  independent ones among them
template <class Values>
Skewness skewness_of(const Values& values, double effective) {
    double n = 0;
    double sum = 0;
    for (const double value : values) {
        sum += value - *std::begin(values);
        ++n;
    }
    const double mean = *std::begin(values) + sum / n;
    double square = 0;
    double cube = 0;
    for (const double value : values) {
        const double d = value - mean;
        square += d * d;
        cube += d * d * d;
    }
    const double scale = 1 / std::sqrt(square / n);
    const double third = cube * scale * scale * scale / n;
    double influence = 0;  // long tails make the error far larger than normal theory does
    for (const double value : values) {
        const double z = (value - mean) * scale;
        const double part = z * (z * z - 3) - third - 1.5 * third * (z * z - 1);
        influence += part * part;
    }
    const double m = std::max(3.0, effective);
    const double normal_error = std::sqrt(6 * m * (m - 1) / ((m - 2) * (m + 1) * (m + 3)));
    return {third * std::sqrt(n * (n - 1)) / (n - 2), std::max(normal_error, std::sqrt(influence / n / m)),
            normal_error};
}

/// @param t  Student's critical value of the tail beyond each limit
inline SkewedReach skewed_reach(const Skewness& skewness, double effective, double t) {
    constexpr double safety = 3;           // standard errors of the skewness
    constexpr double significant = 2;      // of them for normal values
    constexpr double fewest_to_show = 30;  // values that can show symmetry
    constexpr double largest_shift = 1.5;  // of the transformation's argument, which turns at 1
    const auto limit = [&](double value, double& reach, bool& is_open) {
        const double cautious = value + safety * skewness.error;
        reach = t;
        if (cautious <= 0) return;
        const double scale = cautious / std::sqrt(effective);
        const double hall = (1 - std::cbrt(1 - scale * (t + scale / 6))) * 3 / scale;
        const double first_order = t + scale * (2 * t * t + 1) / 6;
        // At a scale of rounding the cubic is a difference of equal numbers.
        reach = scale < 1e-4 ? first_order : std::max({t, hall, first_order});
        const bool seen = value > significant * skewness.normal_error || effective < fewest_to_show;
        is_open = seen && scale * t > largest_shift;
    };
    SkewedReach result;
    limit(-skewness.value, result.below, result.below_is_open);
    limit(skewness.value, result.above, result.above_is_open);
    return result;
}

}  // namespace ff::gate
