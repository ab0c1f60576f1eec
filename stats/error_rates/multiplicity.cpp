#include "stats/error_rates/multiplicity.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace ff::stats {
namespace {

/// Positions of p in ascending order.
std::vector<std::size_t> ascending_order(std::span<const double> p) {
    std::vector<std::size_t> order(p.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [p](std::size_t a, std::size_t b) { return p[a] < p[b]; });
    return order;
}

/// Probability that a variable with the standard Cauchy distribution exceeds x; accurate for large x.
double upper_tail(double x) {
    return x > 1 ? std::atan(1 / x) / std::numbers::pi : 0.5 - std::atan(x) / std::numbers::pi;
}

/// The point that such a variable exceeds with probability p, in (0, 1/2].
double critical(double p) {
    return 1 / std::tan(std::numbers::pi * p);
}

}  // namespace

std::vector<double> holm(std::span<const double> p) {
    std::vector<double> adjusted(p.size());
    double largest = 0;
    std::size_t left = p.size();
    for (const std::size_t i : ascending_order(p)) {
        largest = std::max(largest, p[i] * static_cast<double>(left--));
        adjusted[i] = std::min(1.0, largest);
    }
    return adjusted;
}

std::vector<double> sidak(std::span<const double> p) {
    std::vector<double> adjusted(p.begin(), p.end());
    for (double& value : adjusted) value = -std::expm1(static_cast<double>(p.size()) * std::log1p(-value));
    return adjusted;
}

double sidak_level(double alpha, std::size_t tests) {
    FF_EXPECT(0 < alpha && alpha < 1 && tests >= 1);
    return -std::expm1(std::log1p(-alpha) / static_cast<double>(tests));
}

double bonferroni_level(double alpha, std::size_t tests) {
    FF_EXPECT(0 < alpha && alpha < 1 && tests >= 1);
    return alpha / static_cast<double>(tests);
}

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
