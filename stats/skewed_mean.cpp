#include "stats/skewed_mean.hpp"

#include "core/support/contract.hpp"
#include "stats/distributions.hpp"
#include "stats/moments.hpp"

#include <algorithm>
#include <cmath>

namespace ff::stats {
namespace {

constexpr double safety = 3;           // standard errors of the skewness
constexpr double significant = 2;      // of them for normal values
constexpr double fewest_to_show = 30;  // values that can show symmetry
constexpr double largest_shift = 1.5;  // of the transformation's argument, which turns at 1

struct Skewness {
    double value = 0;
    double error = 0;         ///< standard error, at least that for normal values
    double normal_error = 0;  ///< for normal values
};

/// With the standard error of its influence function, which long tails make far larger than normal theory does.
Skewness skewness_of(std::span<const double> values, double effective) {
    const Moments moments = moments_of(values, values.front());
    const auto n = static_cast<double>(values.size());
    const double sigma = *moments.standard_deviation() * std::sqrt((n - 1) / n);
    const double centre = moments.reference() + *moments.bias();
    double third = 0;
    for (const double value : values) third += std::pow((value - centre) / sigma, 3) / n;
    double square = 0;
    for (const double value : values) {
        const double z = (value - centre) / sigma;
        const double influence = z * z * z - third - 3 * z - 1.5 * third * (z * z - 1);
        square += influence * influence / n;
    }
    const double m = std::max(3.0, effective);
    const double normal = std::sqrt(6 * m * (m - 1) / ((m - 2) * (m + 1) * (m + 3)));
    return {.value = moments.skewness().value_or(0),
            .error = std::max(normal, std::sqrt(square / m)),
            .normal_error = normal};
}

struct Limit {
    double reach = 0;
    bool open = false;
};

/// @param value  of the skewness, positive where it makes this limit fall short
Limit limit(double value, const Skewness& skewness, double n, double t) {
    const double cautious = value + safety * skewness.error;
    if (cautious <= 0) return {.reach = t};
    const double scale = cautious / std::sqrt(n);
    const double hall = (1 - std::cbrt(1 - scale * (t + scale / 6))) * 3 / scale;
    const double first_order = t + scale * (2 * t * t + 1) / 6;
    const bool seen = value > significant * skewness.normal_error || n < fewest_to_show;
    // At a scale of rounding the cubic is a difference of equal numbers.
    return {.reach = scale < 1e-4 ? first_order : std::max({t, hall, first_order}),
            .open = seen && scale * t > largest_shift};
}

}  // namespace

SkewedReach reach_of_mean(std::span<const double> values, double effective, double freedom, double tail) {
    FF_EXPECT(values.size() >= 3 && effective >= 2 && freedom > 0 && 0 < tail && tail < 0.5);
    const double t = student_critical(freedom, tail);
    const Skewness skewness = skewness_of(values, effective);
    const Limit lower = limit(-skewness.value, skewness, effective, t);
    const Limit upper = limit(skewness.value, skewness, effective, t);
    return {.below = lower.reach, .above = upper.reach, .below_is_open = lower.open, .above_is_open = upper.open};
}

}  // namespace ff::stats
