#include "stats/means/mean_interval.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"
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
    double sum = 0.5;       // of the values before, with one in the middle
    double squares = 0.25;  // about their running means, beginning with the largest possible one
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

}  // namespace ff::stats
