#include "stats/means/confidence_sequence.hpp"

#include "core/support/contract.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ff::stats {
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
