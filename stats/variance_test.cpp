#include "stats/variance_test.hpp"

#include "core/contract.hpp"
#include "stats/distributions.hpp"
#include "stats/moments.hpp"
#include "stats/quantiles.hpp"

#include <cmath>
#include <vector>

namespace ff::stats {
namespace {

constexpr std::size_t fewest = 3;

/// Moments of |x - median|.
Moments absolute_deviations(std::span<const double> values) {
    const double median = quantile(sorted(values), 0.5);
    Moments moments;
    for (const double value : values) moments.add(std::abs(value - median));
    return moments;
}

/// Values minus their mean, first `a`'s, then `b`'s.
std::vector<double> centred(std::span<const double> a, std::span<const double> b) {
    std::vector<double> pooled;
    pooled.reserve(a.size() + b.size());
    for (const auto sample : {a, b}) {
        // Measured from the first value, so that a large common offset does not cost digits.
        const double mean = *moments_of(sample, sample.front()).bias();
        for (const double value : sample) pooled.push_back(value - sample.front() - mean);
    }
    return pooled;
}

double variance_of(std::span<const double> values) {
    return *moments_of(values).variance();
}

}  // namespace

std::optional<VarianceTest> test_variances_brown_forsythe(std::span<const double> a, std::span<const double> b) {
    if (a.size() < fewest || b.size() < fewest) return std::nullopt;
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

std::optional<VarianceTest> test_variances_permutation(std::span<const double> a, std::span<const double> b,
                                                       const ResamplingPlan& plan) {
    FF_EXPECT(plan.replicates >= 1);
    if (a.size() < fewest || b.size() < fewest) return std::nullopt;
    std::vector<double> pooled = centred(a, b);
    const std::span<const double> first(pooled.data(), a.size());
    const std::span<const double> second(pooled.data() + a.size(), b.size());
    const double variance_a = variance_of(first);
    const double variance_b = variance_of(second);
    if (variance_a == 0 || variance_b == 0) return std::nullopt;

    VarianceTest test;
    test.ratio = variance_a / variance_b;
    test.statistic = std::log(test.ratio);
    const double seen = std::abs(test.statistic) * (1 - 1e-12);  // the same split in another order counts as equal
    std::uint32_t extreme = 1;
    for (std::uint32_t replicate = 0; replicate < plan.replicates; ++replicate) {
        Draws draws(plan.key, Resampling::permutation, replicate);
        shuffle(pooled, draws);
        if (std::abs(std::log(variance_of(first) / variance_of(second))) >= seen) ++extreme;
    }
    test.p = static_cast<double>(extreme) / (1 + static_cast<double>(plan.replicates));
    return test;
}

}  // namespace ff::stats
