#pragma once

// Shared by stats/means/mean_test.hpp and by stats/gates/gate.hpp: C++17, the standard library alone.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace ff::gate {

/// The skewness of a mean as some values show it: theirs over the root of their number.
struct MeanSkewness {
    double value = 0;
    double error = 0;          ///< standard error of `value`, at least that for normal values
    double insignificant = 0;  ///< largest skewness that says nothing; minus infinity where the values are few
    double most = std::numeric_limits<double>::infinity();  ///< its largest size, where that is known from elsewhere
};

/// Standard error of the skewness of n normal values. @see [joanes1998]
inline double normal_skewness_error(double n) {
    const double m = std::max(3.0, n);
    return std::sqrt(6 * m * (m - 1) / ((m - 2) * (m + 1) * (m + 3)));
}

/// MeanSkewness::insignificant of a mean of so many independent values.
inline double insignificant_skewness(double n) {
    constexpr double fewest_to_show = 30;  // values that can show symmetry
    return n < fewest_to_show ? -std::numeric_limits<double>::infinity() : 2 * normal_skewness_error(n) / std::sqrt(n);
}

/// @param values     at least 3, not all equal
/// @param effective  independent ones among them
template <class Values>
MeanSkewness skewness_of_mean(const Values& values, double effective) {
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
    const double root = std::sqrt(effective);
    MeanSkewness skewness;
    skewness.value = third * std::sqrt(n * (n - 1)) / (n - 2) / root;
    skewness.error =
        std::max(normal_skewness_error(effective), std::sqrt(influence / n / std::max(3.0, effective))) / root;
    skewness.insignificant = insignificant_skewness(effective);
    return skewness;
}

/// How far a limit of a mean lies from it, in standard errors, where the values may be skewed.
///
/// The studentised mean of values with a long upper tail falls low too often: a sample that missed the tail has too
/// small a mean and too small a spread. The reach is Student's t, corrected for skewness by Hall's cubic transformation
/// [hall1992] and, at least, by the first term of its expansion [johnson1978]. Since few values hardly show their
/// skewness, standard errors are added to it: 0.7 times as many as the normal law has to the same tail, so that smaller
/// tails ask for more caution. The factor and the largest shift were chosen by simulation: studies of 1 to 1000 means
/// of 10 to 400 values each (gamma, log-normal, Pareto and Student laws of finite variance) keep their error rate, and
/// normal values lose little power (docs/statistics.md).
///
/// Infinite where the values are too skewed, or too few, for so small a tail.
/// @param side  1: the upper limit; -1: the lower limit
/// @param t     Student's critical value of the tail beyond the limit     @param z  the normal law's
inline double skewed_reach(const MeanSkewness& skewness, int side, double t, double z) {
    constexpr double caution = 0.7;      // standard errors of the skewness for each of the mean
    constexpr double largest_shift = 2;  // largest argument of the transformation, which turns at 1
    const double value = side * skewness.value;
    const double cautious = std::min(value + caution * z * skewness.error, skewness.most);
    if (cautious <= 0) return t;
    if (value > skewness.insignificant && cautious * t > largest_shift) return std::numeric_limits<double>::infinity();
    const double first_order = t + cautious * (2 * t * t + 1) / 6;
    // For a skewness of rounding the cubic is a difference of equal numbers.
    if (cautious < 1e-4) return first_order;
    // Beyond its turn at 1 the inverse of the cubic rises steeply and falls again. A reach must not fall where skewness
    // grows or the tail shrinks, so it stays at the height of the summit, about 4 t, which an argument of 9/8 gives.
    const double argument = cautious * (t + cautious / 6);
    const double hall =
        argument < 1.125 ? (1 - std::cbrt(1 - argument)) * 3 / cautious : 2 * (t + std::sqrt(t * t + 0.75));
    return std::max({t, hall, first_order});
}

/// How far the logarithm of a positive mean may be off where the mean may be so by this share of it.
/// @param side  1: the upper limit; -1: the lower limit
inline double reach_of_logarithm(int side, double share) {
    if (side > 0) return std::log1p(share);
    // A lower limit of a positive mean below a fifth of it is too cautious, and below 0 of no use: large values that
    // raise the mean raise its standard error as well. From there on the logarithm falls in proportion.
    const double proportional = 2 * share;
    return share < 1 ? std::min(-std::log1p(-share), proportional) : proportional;
}

}  // namespace ff::gate
