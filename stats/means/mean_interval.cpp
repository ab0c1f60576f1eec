#include "stats/means/mean_interval.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"
#include "stats/basics/quantiles.hpp"

#include <algorithm>
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

}  // namespace ff::stats
