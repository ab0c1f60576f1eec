#include "stats/error_rates/multiplicity.hpp"

#include "core/support/contract.hpp"

#include <algorithm>
#include <cmath>
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

}  // namespace ff::stats
