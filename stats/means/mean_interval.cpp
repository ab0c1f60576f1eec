#include "stats/means/mean_interval.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"
#include "stats/basics/moments.hpp"
#include "stats/basics/quantiles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace ff::stats {
namespace {

bool spreads(const Moments& moments) {
    return moments.count() >= 2 && *moments.variance() > 0;
}

std::optional<Interval> student_interval(const Moments& moments, std::optional<double> centre, double level) {
    if (!spreads(moments)) return std::nullopt;
    const double t = student_critical(static_cast<double>(moments.count() - 1), (1 - level) / 2);
    return interval_around(*centre, t * *moments.standard_error(), level, "student_t", moments.count());
}

/// More trials than any study has; keeps the following computations within 64 bits.
constexpr double most_trials = 1e18;

std::uint64_t at_least_pilot(Pilot pilot, double trials) {
    return std::max<std::uint64_t>(pilot.n, static_cast<std::uint64_t>(std::ceil(std::min(trials, most_trials))));
}

}  // namespace

std::optional<Interval> mean_interval_t(const Moments& moments, double level) {
    return student_interval(moments, moments.mean(), level);
}

std::optional<Interval> bias_interval_t(const Moments& moments, double level) {
    return student_interval(moments, moments.bias(), level);
}

std::optional<Interval> mean_interval_normal(const Moments& moments, double level) {
    if (!spreads(moments)) return std::nullopt;
    const double half = normal_critical((1 - level) / 2) * *moments.standard_error();
    return interval_around(*moments.mean(), half, level, "normal", moments.count());
}

std::optional<Interval> mean_interval_bootstrap(std::span<const double> values, double level,
                                                const ResamplingPlan& plan) {
    FF_EXPECT(0 < level && level < 1 && plan.replicates >= 1);
    if (!spreads(moments_of(values))) return std::nullopt;
    std::vector<double> sample(values.size());
    std::vector<double> means;
    means.reserve(plan.replicates);
    for (std::uint32_t replicate = 0; replicate < plan.replicates; ++replicate) {
        Draws draws(plan.key, Resampling::bootstrap, replicate);
        resample(values, draws, sample);
        means.push_back(std::accumulate(sample.begin(), sample.end(), 0.0) / static_cast<double>(sample.size()));
    }
    std::sort(means.begin(), means.end());
    const double tail = (1 - level) / 2;
    return Interval{.low = quantile(means, tail),
                    .high = quantile(means, 1 - tail),
                    .level = level,
                    .method = "percentile_bootstrap",
                    .n = values.size()};
}

/// With n values, t²/(n - 1) = r and an effect size of variance g, the factor is sqrt(k) ((1 + r) / (1 + k r))^(n/2),
/// k = 1 / (1 + n g); solved for r.
Interval normal_sequence(std::span<const double> values, double tightest_at, double level) {
    FF_EXPECT(tightest_at > 0);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Interval interval{-infinity, infinity, level, "t_mixture", values.size()};
    const auto n = static_cast<double>(values.size());
    if (values.size() < 2) return interval;
    double mean = 0;
    double squares = 0;
    double count = 0;
    for (const double value : values) {
        const double step = value - mean;
        mean += step / ++count;
        squares += step * (value - mean);
    }
    const double alpha = 1 - level;
    const double evidence = -2 * std::log(alpha);
    const double g = (evidence + std::log1p(evidence)) / tightest_at;
    const double k = 1 / (1 + n * g);
    const double largest = std::exp((evidence - std::log(k)) / n);
    if (k * largest >= 1) return interval;
    const double half = std::sqrt((largest - 1) / (1 - k * largest) * squares / n);
    interval.low = mean - half;
    interval.high = mean + half;
    return interval;
}

Interval bounded_sequence(std::span<const double> values, double low, double high, double level) {
    FF_EXPECT(low < high);
    const double evidence = std::log(2 / (1 - level));
    const double width = high - low;
    Interval interval{low, high, level, "empirical_bernstein", values.size()};
    double weights = 0;
    double weighted = 0;
    double variation = 0;
    double sum = 0.5;       // sum of the values so far and one in the middle
    double squares = 0.25;  // squared deviations from running means, and the largest possible one
    double count = 1;
    for (const double value : values) {
        const double x = (value - low) / width;
        FF_EXPECT(x >= 0 && x <= 1);
        constexpr double largest_weight = 0.5;
        const double weight = std::min(largest_weight, std::sqrt(2 * evidence / (squares * std::log1p(count))));
        const double before = sum / count;
        weights += weight;
        weighted += weight * x;
        variation += (x - before) * (x - before) * (-std::log1p(-weight) - weight);
        sum += x;
        ++count;
        const double now = sum / count;
        squares += (x - now) * (x - now);
        const double middle = weighted / weights;
        const double half = (evidence + variation) / weights;
        interval.low = std::max(interval.low, low + width * (middle - half));
        interval.high = std::min(interval.high, low + width * (middle + half));
    }
    return interval;
}

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
