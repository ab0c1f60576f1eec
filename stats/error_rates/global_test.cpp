#include "stats/error_rates/global_test.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace ff::stats {
namespace {

/// Probability that a variable with the standard Cauchy distribution exceeds x; accurate for large x.
double upper_tail(double x) {
    return x > 1 ? std::atan(1 / x) / std::numbers::pi : 0.5 - std::atan(x) / std::numbers::pi;
}

/// The point that such a variable exceeds with probability p, in (0, 1/2].
double critical(double p) {
    return 1 / std::tan(std::numbers::pi * p);
}

}  // namespace

double simes(std::span<double> p) {
    FF_EXPECT(!p.empty());
    std::sort(p.begin(), p.end());
    double least = 1;
    for (std::size_t i = 0; i < p.size(); ++i)
        least = std::min(least, p[i] * static_cast<double>(p.size()) / static_cast<double>(i + 1));
    return least;
}

double cauchy_combination(std::span<const double> p) {
    FF_EXPECT(!p.empty());
    double sum = 0;
    for (const double value : p) {
        if (value < std::numeric_limits<double>::min()) return 0;
        if (value < 0.5) sum += critical(value);
    }
    const double mean = sum / static_cast<double>(p.size());
    return upper_tail(mean - std::log1p(sum) / std::numbers::pi);
}

double chi_squared_combination(std::span<const double> p) {
    FF_EXPECT(!p.empty());
    double sum = 0;
    for (const double value : p) {
        if (value < std::numeric_limits<double>::min()) return 0;
        sum += std::pow(normal_critical(value / 2), 2);
    }
    return chi_squared_tail(sum, static_cast<double>(p.size()));
}

}  // namespace ff::stats
