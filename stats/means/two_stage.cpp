#include "stats/means/two_stage.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"
#include "stats/basics/moments.hpp"

#include <algorithm>
#include <cmath>

namespace ff::stats {
namespace {

/// More trials than any study has; keeps the following computations within 64 bits.
constexpr double most_trials = 1e18;

std::uint64_t at_least_pilot(Pilot pilot, double trials) {
    return std::max<std::uint64_t>(pilot.n, static_cast<std::uint64_t>(std::ceil(std::min(trials, most_trials))));
}

}  // namespace

std::optional<Pilot> pilot_of(std::span<const double> values, std::size_t n) {
    FF_EXPECT(n >= 2);
    if (values.size() < n) return std::nullopt;
    const double deviation = moments_of(values.first(n), values.front()).standard_deviation().value_or(0.0);
    const Pilot pilot{.n = n, .standard_deviation = deviation, .skewness = {}};
    return pilot.standard_deviation > 0 ? std::optional(pilot) : std::nullopt;
}

std::optional<Pilot> skewed_pilot_of(std::span<const double> values, std::size_t n, double largest_part) {
    FF_EXPECT(n >= 3);
    auto pilot = pilot_of(values, n);
    if (!pilot) return pilot;
    const auto number = static_cast<double>(n);
    pilot->skewness = gate::skewness_of_mean(values.first(n), number);
    pilot->skewness.most = largest_part / pilot->standard_deviation / std::sqrt(number);
    return pilot;
}

gate::MeanSkewness Pilot::skewness_at(std::uint64_t trials) const {
    const double factor = std::sqrt(static_cast<double>(n) / static_cast<double>(trials));
    gate::MeanSkewness scaled = skewness;
    for (double* part : {&scaled.value, &scaled.error, &scaled.insignificant, &scaled.most}) *part *= factor;
    return scaled;
}

double half_width_of(Pilot pilot, std::uint64_t trials, double level) {
    const double tail = (1 - level) / 2;
    const double t = student_critical(pilot.freedom(), tail);
    const double z = normal_critical(tail);
    const gate::MeanSkewness skewness = pilot.skewness_at(trials);
    const double reach = std::max(gate::skewed_reach(skewness, 1, t, z), gate::skewed_reach(skewness, -1, t, z));
    return reach * pilot.standard_deviation / std::sqrt(static_cast<double>(trials));
}

double rmse_of(Pilot pilot, std::uint64_t trials) {
    FF_EXPECT(pilot.n >= 4);
    return pilot.standard_deviation * std::sqrt(pilot.freedom() / (pilot.freedom() - 2) / static_cast<double>(trials));
}

std::uint64_t trials_for_half_width(Pilot pilot, double half_width, double level) {
    FF_EXPECT(half_width > 0);
    const double student = student_critical(pilot.freedom(), (1 - level) / 2) * pilot.standard_deviation / half_width;
    double trials = student * student;
    // Skewness counts less the more trials there are, so that a few steps reach the number.
    while (pilot.skewness.error > 0 && trials < most_trials) {
        const double ratio = half_width_of(pilot, at_least_pilot(pilot, trials), level) / half_width;
        if (ratio <= 1) break;
        trials = std::ceil(std::max(trials, static_cast<double>(pilot.n)) * std::min(2.0, ratio * ratio)) + 1;
    }
    return at_least_pilot(pilot, trials);
}

std::uint64_t trials_for_rmse(Pilot pilot, double rmse) {
    FF_EXPECT(rmse > 0);
    const double ratio = rmse_of(pilot, 1) / rmse;
    return at_least_pilot(pilot, ratio * ratio);
}

}  // namespace ff::stats
