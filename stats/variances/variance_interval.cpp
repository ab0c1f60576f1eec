#include "stats/variances/variance_interval.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"
#include "stats/basics/quantiles.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ff::stats {
namespace {

constexpr std::size_t fewest_with_kurtosis = 4;

double effective_freedom(double freedom, double excess_kurtosis) {
    return freedom / (1 + std::max(0.0, excess_kurtosis) / 2);
}

/// ln s^2 of a sample and its delta-method standard error, sqrt((excess kurtosis + 2) / n).
struct LogVariance {
    double value = 0;
    double standard_error = 0;
};

/// Empty where the sample does not spread, or only between two values half each (standard error 0).
std::optional<LogVariance> log_variance(std::span<const double> centred) {
    const double n = static_cast<double>(centred.size());
    double sum1 = 0, sum2 = 0, sum3 = 0, sum4 = 0;
    for (const double x : centred) {
        const double square = x * x;
        sum1 += x;
        sum2 += square;
        sum3 += square * x;
        sum4 += square * square;
    }
    // A resample's mean is near 0, so moving the moments to it costs no digits.
    const double mean = sum1 / n;
    const double second = sum2 / n - mean * mean;
    const double fourth = sum4 / n - 4 * mean * sum3 / n + 6 * mean * mean * sum2 / n - 3 * std::pow(mean, 4);
    const double spread = fourth / (second * second) - 1;  // excess kurtosis + 2
    constexpr double rounding = 1e-9;
    if (!(second > 0 && spread > rounding)) return std::nullopt;
    return LogVariance{.value = std::log(second * n / (n - 1)), .standard_error = std::sqrt(spread / n)};
}

/// Values minus their mean, in units of their standard deviation, so that no power under- or overflows.
std::vector<double> standardise(std::span<const double> values, const Moments& moments) {
    std::vector<double> result;
    result.reserve(values.size());
    for (const double value : values) {
        result.push_back((value - moments.reference() - *moments.bias()) / *moments.standard_deviation());
    }
    return result;
}

/// Whether too few values, and fewer than half, differ from the most frequent one, which is the median then.
bool is_sparse(std::span<const double> values) {
    const auto most = static_cast<std::size_t>(std::ranges::count(values, median(values)));
    return values.size() - most < std::min(fewest_deviating_values, values.size() / 2);
}

/// Chi-squared intervals are right for normal kurtosis: is the sample's excess within two standard errors of 0? And
/// they are safe for values that crowd at two ends (-2: two values half each), where the bootstrap collapses, since the
/// variance cannot grow with what a resample changes.
bool suits_chi_squared(const Moments& moments) {
    constexpr double two_ended = -1.5;  // a uniform distribution has -1.2
    const auto excess = moments.excess_kurtosis();
    return !excess || *excess < two_ended || std::abs(*excess) <= 2 * *excess_kurtosis_standard_error(moments.count());
}

}  // namespace

std::optional<MeanSquare> mean_square_of(const Moments& moments) {
    const auto excess = moments.excess_kurtosis();
    if (!excess) return std::nullopt;
    return MeanSquare{.mean_square = *moments.variance(),
                      .freedom = effective_freedom(static_cast<double>(moments.count() - 1), *excess),
                      .n = moments.count()};
}

std::optional<MeanSquare> mean_square_about(std::span<const double> values, double reference) {
    const auto n = static_cast<double>(values.size());
    double sum2 = 0;
    double sum4 = 0;
    double scale = 0;
    for (const double value : values) scale = std::max(scale, std::abs(value - reference));
    if (values.size() < fewest_with_kurtosis || scale == 0) return std::nullopt;
    for (const double value : values) {
        const double square = (value - reference) / scale * ((value - reference) / scale);
        sum2 += square;
        sum4 += square * square;
    }
    // (n + 2) / n: unbiased for normal errors.
    const double excess = n * sum4 / (sum2 * sum2) * (n + 2) / n - 3;
    return MeanSquare{
        .mean_square = sum2 / n * scale * scale, .freedom = effective_freedom(n, excess), .n = values.size()};
}

Interval mean_square_interval(const MeanSquare& spread, double level) {
    FF_EXPECT(0 < level && level < 1);
    const double tail = (1 - level) / 2;
    const double sum = spread.mean_square * spread.freedom;
    return {.low = sum / chi_squared_critical(spread.freedom, tail),
            .high = sum / chi_squared_critical(spread.freedom, 1 - tail),
            .level = level,
            .method = "adjusted_chi_squared",
            .n = spread.n};
}

Interval ratio_interval(const MeanSquare& a, const MeanSquare& b, double level) {
    FF_EXPECT(0 < level && level < 1);
    const double tail = (1 - level) / 2;
    const double ratio = a.mean_square / b.mean_square;
    return {.low = std::sqrt(ratio / fisher_critical(tail, a.freedom, b.freedom)),
            .high = std::sqrt(ratio / fisher_critical(1 - tail, a.freedom, b.freedom)),
            .level = level,
            .method = "adjusted_f",
            .n = std::min(a.n, b.n)};
}

std::optional<Interval> variance_interval_chi2(const Moments& moments, double level) {
    FF_EXPECT(0 < level && level < 1);
    if (moments.count() < 2 || *moments.variance() == 0) return std::nullopt;
    const auto freedom = static_cast<double>(moments.count() - 1);
    Interval interval = mean_square_interval({*moments.variance(), freedom, moments.count()}, level);
    interval.method = "chi_squared";
    return interval;
}

std::optional<Interval> variance_interval_bootstrap(std::span<const double> values, double level,
                                                    const ResamplingPlan& plan) {
    FF_EXPECT(0 < level && level < 1 && plan.replicates >= 1);
    if (values.size() < fewest_for_variance_bootstrap || is_sparse(values)) return std::nullopt;
    const Moments moments = moments_of(values, values.front());
    const std::vector<double> data = standardise(values, moments);
    const auto seen = log_variance(data);
    if (!seen) return std::nullopt;

    std::vector<double> sample(data.size());
    std::vector<double> studentised;
    studentised.reserve(plan.replicates);
    for (std::uint32_t replicate = 0; replicate < plan.replicates; ++replicate) {
        Draws draws(plan.key, Resampling::bootstrap, replicate);
        resample(data, draws, sample);
        if (const auto drawn = log_variance(sample)) {
            studentised.push_back((drawn->value - seen->value) / drawn->standard_error);
        }
    }
    if (studentised.empty()) return std::nullopt;
    std::sort(studentised.begin(), studentised.end());
    const double variance = *moments.variance();
    return Interval{.low = variance * std::exp(-quantile(studentised, (1 + level) / 2) * seen->standard_error),
                    .high = variance * std::exp(-quantile(studentised, (1 - level) / 2) * seen->standard_error),
                    .level = level,
                    .method = "studentised_bootstrap",
                    .n = values.size()};
}

std::optional<Interval> variance_interval(std::span<const double> values, double level, const ResamplingPlan& plan) {
    if (values.empty() || is_sparse(values)) return std::nullopt;
    const Moments moments = moments_of(values, values.front());
    if (values.size() < fewest_for_variance_bootstrap || suits_chi_squared(moments)) {
        return variance_interval_chi2(moments, level);
    }
    if (values.size() >= enough_for_kurtosis) return mean_square_interval(*mean_square_of(moments), level);
    return variance_interval_bootstrap(values, level, plan);
}

std::optional<Interval> standard_deviation_interval(std::span<const double> values, double level,
                                                    const ResamplingPlan& plan) {
    const auto interval = variance_interval(values, level, plan);
    if (!interval) return std::nullopt;
    return square_root(*interval);
}

}  // namespace ff::stats
