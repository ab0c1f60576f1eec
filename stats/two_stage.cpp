#include "stats/two_stage.hpp"

#include "core/support/contract.hpp"
#include "stats/distributions.hpp"

#include <algorithm>
#include <cmath>

namespace ff::stats {
namespace {

/// More trials than any study has; keeps what follows within 64 bits.
constexpr double most_trials = 1e18;

std::uint64_t at_least_pilot(Pilot pilot, double trials) {
    return std::max<std::uint64_t>(pilot.n, static_cast<std::uint64_t>(std::ceil(std::min(trials, most_trials))));
}

double freedom(Pilot pilot) {
    return static_cast<double>(pilot.n - 1);
}

double standard_error(const Moments& all, Pilot pilot) {
    return pilot.standard_deviation / std::sqrt(static_cast<double>(all.count()));
}

}  // namespace

std::optional<Pilot> pilot_of(std::span<const double> values, std::size_t n) {
    FF_EXPECT(n >= 2);
    if (values.size() < n) return std::nullopt;
    const Pilot pilot{n, moments_of(values.first(n), values.front()).standard_deviation().value_or(0.0)};
    return pilot.standard_deviation > 0 ? std::optional(pilot) : std::nullopt;
}

double half_width_of(Pilot pilot, std::uint64_t trials, double level) {
    return student_critical(freedom(pilot), (1 - level) / 2) * pilot.standard_deviation /
           std::sqrt(static_cast<double>(trials));
}

double rmse_of(Pilot pilot, std::uint64_t trials) {
    FF_EXPECT(pilot.n >= 4);
    return pilot.standard_deviation * std::sqrt(freedom(pilot) / (freedom(pilot) - 2) / static_cast<double>(trials));
}

std::uint64_t trials_for_half_width(Pilot pilot, double half_width, double level) {
    FF_EXPECT(half_width > 0);
    const double ratio = half_width_of(pilot, 1, level) / half_width;
    return at_least_pilot(pilot, ratio * ratio);
}

std::uint64_t trials_for_rmse(Pilot pilot, double rmse) {
    FF_EXPECT(rmse > 0);
    const double ratio = rmse_of(pilot, 1) / rmse;
    return at_least_pilot(pilot, ratio * ratio);
}

Interval bias_interval_two_stage(const Moments& all, Pilot pilot, double level) {
    const double reach = student_critical(freedom(pilot), (1 - level) / 2) * standard_error(all, pilot);
    return {.low = *all.bias() - reach,
            .high = *all.bias() + reach,
            .level = level,
            .method = "stein_two_stage",
            .n = all.count()};
}

std::optional<BiasTest> test_bias(const Moments& all, const std::optional<Pilot>& pilot) {
    if (!pilot) return test_bias(all);
    BiasTest test;
    test.bias = *all.bias();
    test.standard_error = standard_error(all, *pilot);
    test.t = test.bias / test.standard_error;
    test.freedom = freedom(*pilot);
    test.p = student_two_sided_p(test.t, test.freedom);
    return test;
}

std::optional<EquivalenceTest> test_equivalence(const Moments& all, const std::optional<Pilot>& pilot, double margin,
                                                double alpha) {
    if (!pilot) return test_equivalence(all, margin, alpha);
    EquivalenceTest test;
    test.interval = bias_interval_two_stage(all, *pilot, 1 - 2 * alpha);
    test.margin = margin;
    test.p = student_tail((margin - std::abs(*all.bias())) / standard_error(all, *pilot), freedom(*pilot));
    test.equivalent = -margin < test.interval.low && test.interval.high < margin;
    test.different = test.interval.low > margin || test.interval.high < -margin;
    return test;
}

}  // namespace ff::stats
