#include "stats/repeats.hpp"

#include "stats/moments.hpp"

#include <boost/math/special_functions/gamma.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>
#include <vector>

namespace ff::stats {
namespace {

/// Spacing of the lattice that ascending distinct values lie on; 0 where they lie on none.
double find_spacing(const std::vector<double>& distinct) {
    std::vector<double> gaps;
    for (std::size_t i = 1; i < distinct.size(); ++i) gaps.push_back(distinct[i] - distinct[i - 1]);
    if (gaps.empty()) return 0;
    const double least = *std::min_element(gaps.begin(), gaps.end());
    // Values of a lattice are dense enough that some are neighbours, or nearly so; rounding is far below this.
    const double none = least / 50;
    double spacing = least;
    for (double gap : gaps) {
        while (gap > none) {
            const double rest = std::abs(std::remainder(gap, spacing));
            if (rest <= none) break;
            gap = spacing;
            spacing = rest;
        }
        if (spacing <= none * 2) return 0;
    }
    return spacing;
}

/// Of n draws from a normal distribution on a lattice, those that are equal to an earlier one.
/// @param crowding  n * spacing / sigma
double expected_repeats(double n, double crowding) {
    if (crowding == 0) return 0;
    constexpr double reach = 8;
    constexpr int steps = 1600;
    // Sites are hit with rate a = crowding * density, and hit a - (1 - exp(-a)) times too often.
    double sum = 0;
    for (int i = 0; i <= steps; ++i) {
        const double z = reach * (2.0 * i / steps - 1);
        const double rate = crowding * std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi);
        sum += rate + std::expm1(-rate);
    }
    return n / crowding * sum * (2 * reach / steps);
}

}  // namespace

std::optional<Repeats> find_repeats(std::span<const double> values) {
    Repeats found;
    std::unordered_map<double, std::size_t> seen;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto [place, is_new] = seen.emplace(values[i], i);
        if (is_new) continue;
        if (found.repeats++ > 0) continue;
        found.earlier = place->second;
        found.later = i;
    }
    if (found.repeats == 0) return std::nullopt;
    std::vector<double> distinct;
    for (const auto& [value, index] : seen) distinct.push_back(value);
    std::sort(distinct.begin(), distinct.end());
    const auto n = static_cast<double>(values.size());
    if (distinct.size() > 1) {
        const double sigma = *moments_of(values).standard_deviation();
        found.expected = expected_repeats(n, n * find_spacing(distinct) / sigma);
    }
    found.p = found.expected == 0 ? 0 : boost::math::gamma_p(static_cast<double>(found.repeats), found.expected);
    return found;
}

std::optional<std::size_t> find_period(std::span<const double> values, double alpha) {
    const std::size_t n = values.size();
    std::unordered_map<double, double> counts;
    for (const double value : values) ++counts[value];
    double coincidence = 0;  // probability that two values are equal
    for (const auto& [value, count] : counts) coincidence += std::pow(count / static_cast<double>(n), 2);
    for (std::size_t lag = 1; lag <= n / 2; ++lag) {
        if (!std::equal(values.begin() + static_cast<std::ptrdiff_t>(lag), values.end(), values.begin())) continue;
        const double by_chance = static_cast<double>(n) / 2 * std::pow(coincidence, static_cast<double>(n - lag));
        return by_chance <= alpha ? std::optional(lag) : std::nullopt;
    }
    return std::nullopt;
}

}  // namespace ff::stats
