#include "tests/support/statistical_assertions.hpp"

#include "stats/basics/binomial.hpp"
#include "stats/error_rates/power.hpp"
#include "stats/means/mean_test.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ff::test {
namespace {

using testing::AssertionFailure;
using testing::AssertionResult;
using testing::AssertionSuccess;

/// Fails where `detectable`, the effect noticed with the stated power, is larger than promised.
AssertionResult sharp_enough(double detectable, StatisticalRisk risk) {
    if (detectable <= risk.detects) return AssertionSuccess();
    return AssertionFailure() << "the test would notice " << detectable << " with probability " << risk.power
                              << ", but must notice " << risk.detects << ". Use more trials";
}

AssertionResult judge(double p, double detectable, StatisticalRisk risk) {
    if (p < risk.alpha) return AssertionFailure() << "p = " << p << " < alpha = " << risk.alpha;
    return sharp_enough(detectable, risk);
}

/// The smallest rise of the probability that is noticed with this power; infinite where none is. `fails` says
/// whether the assertion fails with so many hits.
template <class Fails>
double detectable_rise(std::uint64_t trials, double probability, double power, const Fails& fails) {
    auto fewest = static_cast<std::uint64_t>(std::ceil(static_cast<double>(trials) * probability));
    std::uint64_t failing = trials;
    if (!fails(failing)) return std::numeric_limits<double>::infinity();
    while (fewest < failing) {
        const std::uint64_t middle = fewest + (failing - fewest) / 2;
        if (fails(middle))
            failing = middle;
        else
            fewest = middle + 1;
    }
    double unnoticed = 0;
    double noticed = 1 - probability;
    while (noticed - unnoticed > 1e-6) {
        const double rise = (unnoticed + noticed) / 2;
        (stats::binomial_upper_p({failing, trials}, probability + rise) < power ? unnoticed : noticed) = rise;
    }
    return noticed;
}

AssertionResult describe(AssertionResult result, std::uint64_t hits, std::uint64_t trials, double probability) {
    if (result) return result;
    return result << ": " << hits << " of " << trials << " against probability " << probability;
}

}  // namespace

AssertionResult unbiased(std::span<const double> replicates, double truth, StatisticalRisk risk) {
    const auto mean = stats::mean_evidence(replicates, truth, stats::not_skewed);
    if (!mean) return AssertionFailure() << replicates.size() << " replicates without spread show nothing";
    const double detectable =
        stats::minimum_detectable_bias(mean->standard_error * std::sqrt(static_cast<double>(replicates.size())),
                                       replicates.size(), {.alpha = risk.alpha, .power = risk.power});
    AssertionResult result = judge(stats::test_mean(*mean).p, detectable, risk);
    if (result) return result;
    return result << ": bias " << mean->difference << " with standard error " << mean->standard_error;
}

AssertionResult has_probability(std::uint64_t hits, std::uint64_t trials, double probability, StatisticalRisk risk) {
    const auto fails = [&](std::uint64_t count) {
        return stats::binomial_two_sided_p({count, trials}, probability) < risk.alpha;
    };
    // A shift is noticed in both directions, where the probability leaves room for it.
    double detectable = 0;
    if (probability + risk.detects <= 1) detectable = detectable_rise(trials, probability, risk.power, fails);
    if (probability - risk.detects >= 0)
        detectable =
            std::max(detectable, detectable_rise(trials, 1 - probability, risk.power,
                                                 [&](std::uint64_t misses) { return fails(trials - misses); }));
    const double p = stats::binomial_two_sided_p({hits, trials}, probability);
    return describe(judge(p, detectable, risk), hits, trials, probability);
}

AssertionResult has_probability_at_least(std::uint64_t hits, std::uint64_t trials, double probability,
                                         StatisticalRisk risk) {
    const auto p = [&](std::uint64_t count) { return stats::binomial_lower_p({count, trials}, probability); };
    const double detectable = detectable_rise(trials, 1 - probability, risk.power,
                                              [&](std::uint64_t misses) { return p(trials - misses) < risk.alpha; });
    return describe(judge(p(hits), detectable, risk), hits, trials, probability);
}

AssertionResult has_probability_at_most(std::uint64_t hits, std::uint64_t trials, double probability,
                                        StatisticalRisk risk) {
    const auto p = [&](std::uint64_t count) { return stats::binomial_upper_p({count, trials}, probability); };
    const double detectable =
        detectable_rise(trials, probability, risk.power, [&](std::uint64_t count) { return p(count) < risk.alpha; });
    return describe(judge(p(hits), detectable, risk), hits, trials, probability);
}

}  // namespace ff::test
