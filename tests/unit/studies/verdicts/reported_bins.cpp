#include "studies/verdicts/reported/reported_bins.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ff::studies::gates {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

BinEffect difference(double value, double error, double freedom, double band) {
    BinEffect bin;
    bin.value = value;
    bin.error = error;
    bin.freedom = freedom;
    bin.band = {-band, band};
    return bin;
}

BinEffect ratio(double value, double freedom, double freedom_below) {
    BinEffect bin;
    bin.value = value;
    bin.freedom = freedom;
    bin.freedom_below = freedom_below;
    bin.band = {0.5, 2};
    return bin;
}

BinEffects only(const BinEffect& bin, EffectScale scale) {
    return {.scale = scale, .bins = {bin}, .shares = {}, .together = {}};
}

double p_of(const BinEffect& bin, EffectScale scale) {
    return p_value(only(bin, scale), 0);
}

BinEffects share(std::uint64_t hits, std::uint64_t trials, const stats::ShareReference& reference, double band) {
    BinEffect bin = difference(static_cast<double>(hits) / static_cast<double>(trials) - reference.value, 0.01,
                               static_cast<double>(trials), band);
    return {.scale = EffectScale::difference_of_shares,
            .bins = {bin},
            .shares = {{{hits, trials}, reference}},
            .together = {}};
}

TEST(PValueOfABin, IsOneInsideTheBandAndUsesTheNearerEndOutside) {
    const auto scale = EffectScale::difference;
    EXPECT_EQ(p_of(difference(1, 1, 10, 2), scale), 1);
    EXPECT_NEAR(p_of(difference(5, 1, 10, 2), scale), 0.013343655022569565, 1e-12);  // SciPy: 2 * t.sf(3, 10)
    EXPECT_NEAR(p_of(difference(-5, 1, 10, 2), scale), 0.013343655022569565, 1e-12);
    EXPECT_NEAR(p_of(difference(5, 1, infinity, 2), scale), 0.0026997960632601866, 1e-12);  // SciPy: 2 * norm.sf(3)
}

TEST(PValueOfABin, IsTheTailOfFBeyondTheEndForARatio) {
    // SciPy: 2 * f.sf(1.5**2, 10, 20), 2 * f.sf(1.5, 10, 20)
    EXPECT_NEAR(p_of(ratio(3, 10, 20), EffectScale::ratio_of_deviations), 0.11772873371246975, 1e-12);
    EXPECT_NEAR(p_of(ratio(3, 10, 20), EffectScale::ratio_of_variances), 0.42189292503722553, 1e-12);
    // SciPy: 2 * f.sf(2**2, 20, 10)
    EXPECT_NEAR(p_of(ratio(0.25, 10, 20), EffectScale::ratio_of_deviations), 0.028600199069083825, 1e-12);
}

TEST(PValueOfABin, IsABinomialTailForAShare) {
    // By fractions: twice the sum of C(100, k) p^k (1 - p)^(100 - k), k >= 30 at p = 0.2, k <= 2 at p = 0.1
    EXPECT_NEAR(p_value(share(30, 100, {.value = 0.1}, 0.1), 0), 0.02249795744198327, 1e-12);
    EXPECT_NEAR(p_value(share(2, 100, {.value = 0.2}, 0.1), 0), 0.0038897693037600327, 1e-12);
    EXPECT_EQ(p_value(share(0, 100, {.value = 0.0}, 0.1), 0), 1);
}

TEST(MeasureBin, HasIntervalsThatAgreeWithThePValue) {
    for (const double value : {2.5, 4.0, 7.0, -3.0, 0.5}) {
        const BinEffects bin = only(difference(value, 1, 30, 1), EffectScale::difference);
        const double p = p_value(bin, 0);
        for (const double alpha : {1e-1, 1e-3, 1e-5}) {
            const Levels levels{.fail_alpha = alpha, .pass_alpha = 0.05, .power = 0.9};
            const auto verdict = judge(measure_bin(bin, 0, levels), bin.bins[0].band);
            EXPECT_EQ(verdict == Verdict::fail, p < alpha) << value << " " << alpha;
        }
    }
    for (const double value : {0.1, 0.4, 1.0, 2.5, 6.0}) {
        const BinEffects bin = only(ratio(value, 12, 30), EffectScale::ratio_of_deviations);
        const double p = p_value(bin, 0);
        const Levels levels{.fail_alpha = 1e-3, .pass_alpha = 0.05, .power = 0.9};
        const auto verdict = judge(measure_bin(bin, 0, levels), bin.bins[0].band);
        EXPECT_EQ(verdict == Verdict::fail, p < 1e-3) << value;
    }
    const stats::ShareReference other{.value = 0.1, .counts = stats::Proportion{5, 50}};
    for (const std::uint64_t hits : {0u, 1u, 5u, 20u, 40u, 80u, 100u}) {
        for (const stats::ShareReference& reference : {stats::ShareReference{.value = 0.1}, other}) {
            const BinEffects bin = share(hits, 100, reference, 0.05);
            const double p = p_value(bin, 0);
            const Levels levels{.fail_alpha = 1e-3, .pass_alpha = 0.05, .power = 0.9};
            const auto verdict = judge(measure_bin(bin, 0, levels), bin.bins[0].band);
            EXPECT_EQ(verdict == Verdict::fail, p < 1e-3) << hits;
        }
    }
}

BinEffects ten_bins(double value_of_the_last, double band) {
    BinEffects effects;
    for (int i = 0; i < 9; ++i) effects.bins.push_back(difference(0.1 * i, 1, infinity, band));
    effects.bins.push_back(difference(value_of_the_last, 1, infinity, band));
    return effects;
}

TEST(JudgeBins, FailsByTheWorstBinAndNamesIt) {
    // SciPy: 20 * norm.sf(4.5) = 6.8e-5, 20 * norm.sf(4.3) = 1.7e-4
    const auto verdict = judge_bins(ten_bins(5.5, 1), Combination::holm, 1e-4, 0.05);
    EXPECT_EQ(verdict.verdict, Verdict::fail);
    EXPECT_EQ(verdict.worst.front(), 9u);
    EXPECT_EQ(verdict.rejected, 1u);
    EXPECT_EQ(judge_bins(ten_bins(5.3, 1), Combination::holm, 1e-4, 0.05).verdict, Verdict::inconclusive);
}

TEST(JudgeBins, PassesOnlyWhereEveryBinIsShownToLieInside) {
    EXPECT_EQ(judge_bins(ten_bins(0.8, 3), Combination::holm, 1e-4, 0.05).verdict, Verdict::pass);
    const auto verdict = judge_bins(ten_bins(1.4, 3), Combination::cauchy, 1e-4, 0.05);
    EXPECT_EQ(verdict.verdict, Verdict::inconclusive);
    EXPECT_EQ(verdict.undecided, 1u);
}

TEST(JudgeBins, FailsTogetherWhenNoBinFailsAlone) {
    BinEffects effects;
    for (int i = 0; i < 100; ++i) effects.bins.push_back(difference(3.5, 1, infinity, 1e-9));
    EXPECT_EQ(judge_bins(effects, Combination::holm, 1e-3, 0.05).verdict, Verdict::inconclusive);
    EXPECT_EQ(judge_bins(effects, Combination::simes, 1e-3, 0.05).verdict, Verdict::fail);
    EXPECT_EQ(judge_bins(effects, Combination::cauchy, 1e-3, 0.05).verdict, Verdict::fail);
}

TEST(CountScores, PutsOutlyingScoresIntoTheEndBins) {
    const auto counts = count_scores({difference(100, 1, 1, 1), difference(-100, 1, 1, 1), difference(0.1, 1, 1, 1)});
    EXPECT_EQ(counts.front(), 1u);
    EXPECT_EQ(counts.back(), 1u);
    EXPECT_EQ(counts[counts.size() / 2], 1u);
}

}  // namespace
}  // namespace ff::studies::gates
