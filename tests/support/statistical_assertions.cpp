#include "tests/support/statistical_assertions.hpp"

#include "stats/basics/binomial.hpp"
#include "stats/basics/distributions.hpp"
#include "stats/error_rates/power.hpp"
#include "stats/means/mean_test.hpp"

#include <cmath>

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

/// Shift that a binomial test notices (normal approximation with the variance of the null).
double detectable_shift(std::uint64_t trials, double probability, StatisticalRisk risk, double sides) {
    const double sd = std::sqrt(probability * (1 - probability) / static_cast<double>(trials));
    return (stats::normal_critical(risk.alpha / sides) + stats::normal_critical(1 - risk.power)) * sd;
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
    const double p = stats::binomial_two_sided_p({hits, trials}, probability);
    return describe(judge(p, detectable_shift(trials, probability, risk, 2), risk), hits, trials, probability);
}

AssertionResult has_probability_at_least(std::uint64_t hits, std::uint64_t trials, double probability,
                                         StatisticalRisk risk) {
    const double p = stats::binomial_lower_p({hits, trials}, probability);
    return describe(judge(p, detectable_shift(trials, probability, risk, 1), risk), hits, trials, probability);
}

AssertionResult has_probability_at_most(std::uint64_t hits, std::uint64_t trials, double probability,
                                        StatisticalRisk risk) {
    const double p = stats::binomial_upper_p({hits, trials}, probability);
    return describe(judge(p, detectable_shift(trials, probability, risk, 1), risk), hits, trials, probability);
}

}  // namespace ff::test
