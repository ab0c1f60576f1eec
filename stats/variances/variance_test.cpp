#include "stats/variances/variance_test.hpp"

#include "stats/basics/distributions.hpp"
#include "stats/basics/moments.hpp"
#include "stats/basics/quantiles.hpp"

#include <cmath>

namespace ff::stats {
namespace {

constexpr std::size_t fewest_in_a_sample = 3;

/// Moments of |x - median|.
Moments absolute_deviations(std::span<const double> values) {
    const double median = quantile(sorted(values), 0.5);
    Moments moments;
    for (const double value : values) moments.add(std::abs(value - median));
    return moments;
}

}  // namespace

std::optional<VarianceTest> test_variances_brown_forsythe(std::span<const double> a, std::span<const double> b) {
    if (a.size() < fewest_in_a_sample || b.size() < fewest_in_a_sample) return std::nullopt;
    const Moments from_a = absolute_deviations(a);
    const Moments from_b = absolute_deviations(b);
    const double size_a = static_cast<double>(a.size());
    const double size_b = static_cast<double>(b.size());
    const double freedom = size_a + size_b - 2;
    const double within = (*from_a.variance() * (size_a - 1) + *from_b.variance() * (size_b - 1)) / freedom;
    const double variance_b = *moments_of(b, b.front()).variance();
    if (within == 0 || variance_b == 0) return std::nullopt;

    const double difference = *from_a.mean() - *from_b.mean();
    VarianceTest test;
    test.ratio = *moments_of(a, a.front()).variance() / variance_b;
    test.statistic = difference * difference / (within * (1 / size_a + 1 / size_b));
    test.p = fisher_tail(test.statistic, 1, freedom);
    return test;
}

}  // namespace ff::stats
