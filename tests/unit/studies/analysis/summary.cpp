#include "studies/analysis/summary.hpp"

#include <gtest/gtest.h>

#include <array>

namespace ff::studies {
namespace {

// Expected values: python3 with
//   import numpy as np; from scipy import special, stats  # stats.t.ppf is right to 9 digits
//   v = np.array([0.19, 0.21, 0.2, 0.205, 0.198, 0.202, 0.207, 0.193]); r = 0.2; n = len(v); e = v - r
//   s = v.std(ddof=1); t = np.sqrt((n - 1) * (1 / special.betaincinv((n - 1) / 2, .5, .05) - 1)); h = t * s / n**.5
//   e.mean(), s / n**.5, e.mean() - h, e.mean() + h, s                       # bias ... std
//   s * np.sqrt((n - 1) / stats.chi2.ppf([.975, .025], n - 1))               # interval of std
//   np.sqrt((e**2).mean()), np.median(abs(e)), (100 * abs(e) / r).mean()
//   stats.skew(v, bias=False), stats.kurtosis(v, bias=False)
//   np.quantile(v, [0, .025, .05, .5, .95, .975, 1])
//   d = v - v.mean(); (d**4).sum() / (d**2).sum()**2 - 1 / n; 1 / (s * s * 1000)
constexpr std::array eight_estimates{0.19, 0.21, 0.2, 0.205, 0.198, 0.202, 0.207, 0.193};

SummaryRequest request() {
    SummaryRequest request;
    request.quantity = {QuantityKind::form_factor, 1, 2};
    request.reference = 0.2;
    request.evaluations_per_face = 1000;
    request.limits = stats::not_skewed;
    request.key = derive_key(Seed{1}, "summary");
    return request;
}

TEST(Summary, AgreesWithNumpy) {
    const Summary s = summarise(eight_estimates, request());
    EXPECT_EQ(s.trials, 8u);
    EXPECT_NEAR(s.mean.value(), 0.200625, 1e-15);
    EXPECT_NEAR(s.bias.value(), 0.000625, 1e-15);
    EXPECT_NEAR(s.bias_se.value(), 0.0024196922767752314, 1e-15);
    EXPECT_NEAR(s.bias_interval.value().low, -0.0050966630390544831, 1e-12);
    EXPECT_NEAR(s.bias_interval.value().high, 0.0063466630390544634, 1e-12);
    EXPECT_NEAR(s.std.value(), 0.0068439232691699312, 1e-15);
    EXPECT_NEAR(s.std_interval.value().low, 0.0045250251421604364, 1e-12);
    EXPECT_NEAR(s.std_interval.value().high, 0.013929246021182527, 1e-12);
    EXPECT_NEAR(s.rmse.value(), 0.0064323401651342977, 1e-15);
    EXPECT_NEAR(s.median_abs_error.value(), 0.006, 1e-15);
    EXPECT_NEAR(s.relative_error_percent.value(), 2.6875, 1e-12);
    EXPECT_NEAR(s.skewness.value(), -0.29217433897251016, 1e-10);
    EXPECT_NEAR(s.excess_kurtosis.value(), -0.84953825720418719, 1e-10);
    EXPECT_NEAR(s.vov.value(), 0.11609891326165553, 1e-10);
    EXPECT_NEAR(s.efficiency_samples.value(), 21.349599695005757, 1e-9);
    EXPECT_NEAR(s.min.value(), 0.19, 1e-15);
    EXPECT_NEAR(s.q025.value(), 0.190525, 1e-15);
    EXPECT_NEAR(s.q05.value(), 0.19105, 1e-15);
    EXPECT_NEAR(s.median.value(), 0.201, 1e-15);
    EXPECT_NEAR(s.q95.value(), 0.20895, 1e-15);
    EXPECT_NEAR(s.q975.value(), 0.209475, 1e-15);
    EXPECT_NEAR(s.max.value(), 0.21, 1e-15);
}

TEST(Summary, TakesLevelAndDetectableBiasFromTheRequest) {
    SummaryRequest other = request();
    other.level = 0.99;
    other.detectable_bias = 3;
    const Summary s = summarise(eight_estimates, other);
    EXPECT_GT(s.bias_interval->width(), summarise(eight_estimates, request()).bias_interval->width());
    EXPECT_NEAR(s.minimum_detectable_bias.value(), 3 * 0.0068439232691699312, 1e-15);
}

TEST(Summary, HasNoIntervalUnderInfiniteVarianceButKeepsEstimates) {
    SummaryRequest infinite = request();
    infinite.variance = VarianceStatus::infinite;
    const Summary s = summarise(eight_estimates, infinite);
    EXPECT_TRUE(s.mean && s.bias && s.rmse && s.median && s.median_abs_error && s.std && s.vov);
    EXPECT_FALSE(s.bias_se || s.bias_interval || s.std_interval || s.minimum_detectable_bias || s.efficiency_samples);
}

TEST(Summary, HasNoSpreadForADeterministicMethod) {
    SummaryRequest deterministic = request();
    deterministic.variance = VarianceStatus::none;
    const std::array one{0.21};
    const Summary s = summarise(one, deterministic);
    EXPECT_NEAR(s.bias.value(), 0.01, 1e-15);
    EXPECT_NEAR(s.rmse.value(), 0.01, 1e-15);
    EXPECT_EQ(s.median, 0.21);
    EXPECT_FALSE(s.bias_se || s.bias_interval || s.std || s.std_interval || s.minimum_detectable_bias || s.skewness ||
                 s.normality_p || s.vov || s.tail_index || s.efficiency_samples);
}

TEST(Summary, HasZeroSpreadAndNoTestForEqualValues) {
    const std::array equal{0.2, 0.2, 0.2, 0.2};
    const Summary s = summarise(equal, request());
    EXPECT_EQ(s.std, 0.0);
    EXPECT_FALSE(s.bias_se || s.bias_interval || s.std_interval || s.minimum_detectable_bias || s.normality_p ||
                 s.efficiency_samples);
}

TEST(Summary, HasNoBiasWithoutAReference) {
    SummaryRequest unknown = request();
    unknown.reference.reset();
    const Summary s = summarise(eight_estimates, unknown);
    EXPECT_NEAR(s.mean.value(), 0.200625, 1e-15);
    EXPECT_TRUE(s.std_interval);
    EXPECT_FALSE(s.bias || s.bias_se || s.bias_interval || s.rmse || s.relative_error_percent || s.median_abs_error);
}

TEST(Summary, IsEmptyWithoutTrials) {
    const Summary s = summarise({}, request());
    EXPECT_EQ(s.trials, 0u);
    EXPECT_FALSE(s.mean || s.bias || s.min || s.std);
}

TEST(Summary, HasNoSpreadForOneTrial) {
    const std::array one{0.21};
    const Summary s = summarise(one, request());
    EXPECT_EQ(s.mean, 0.21);
    EXPECT_FALSE(s.std || s.bias_interval || s.minimum_detectable_bias);
}

TEST(Summary, JittersCountsBeforeTestingNormality) {
    // Two neighbouring counts only: no continuous distribution, but half a hit of jitter fills the gap.
    std::array<double, 40> counts{};
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = i % 2 == 0 ? 0.2 : 0.201;
    SummaryRequest lattice = request();
    lattice.lattice = 0.001;
    EXPECT_GT(summarise(counts, lattice).normality_p.value(), 1e-4);
    EXPECT_LT(summarise(counts, request()).normality_p.value(), 1e-4);
    EXPECT_EQ(summarise(counts, lattice).std, summarise(counts, request()).std);
}

}  // namespace
}  // namespace ff::studies
