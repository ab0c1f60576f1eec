#include "studies/verdicts/reported_bins.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ff::studies {
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

TEST(PValueOfABin, IsOneInsideTheBandAndThatOfTheNearerEndOutside) {
    const auto scale = EffectScale::difference;
    EXPECT_EQ(p_value(difference(1, 1, 10, 2), scale), 1);
    EXPECT_NEAR(p_value(difference(5, 1, 10, 2), scale), 0.013343655022569565, 1e-12);  // SciPy: 2 * t.sf(3, 10)
    EXPECT_NEAR(p_value(difference(-5, 1, 10, 2), scale), 0.013343655022569565, 1e-12);
    EXPECT_NEAR(p_value(difference(5, 1, infinity, 2), scale), 0.0026997960632601866, 1e-12);  // SciPy: 2 * norm.sf(3)
}

TEST(PValueOfABin, OfARatioIsThatOfFBeyondTheEnd) {
    // SciPy: 2 * f.sf(1.5**2, 10, 20), 2 * f.sf(1.5, 10, 20)
    EXPECT_NEAR(p_value(ratio(3, 10, 20), EffectScale::ratio_of_deviations), 0.11772873371246975, 1e-12);
    EXPECT_NEAR(p_value(ratio(3, 10, 20), EffectScale::ratio_of_variances), 0.42189292503722553, 1e-12);
    // SciPy: 2 * f.sf(2**2, 20, 10)
    EXPECT_NEAR(p_value(ratio(0.25, 10, 20), EffectScale::ratio_of_deviations), 0.028600199069083825, 1e-12);
}

TEST(MeasureBin, HasIntervalsThatAgreeWithThePValue) {
    for (const double value : {2.5, 4.0, 7.0, -3.0, 0.5}) {
        const BinEffect bin = difference(value, 1, 30, 1);
        const double p = p_value(bin, EffectScale::difference);
        for (const double alpha : {1e-1, 1e-3, 1e-5}) {
            const Levels levels{.fail_alpha = alpha, .pass_alpha = 0.05, .power = 0.9};
            const auto verdict = judge(measure_bin(bin, EffectScale::difference, levels), bin.band);
            EXPECT_EQ(verdict == Verdict::fail, p < alpha) << value << " " << alpha;
        }
    }
    for (const double value : {0.1, 0.4, 1.0, 2.5, 6.0}) {
        const BinEffect bin = ratio(value, 12, 30);
        const double p = p_value(bin, EffectScale::ratio_of_deviations);
        const Levels levels{.fail_alpha = 1e-3, .pass_alpha = 0.05, .power = 0.9};
        const auto verdict = judge(measure_bin(bin, EffectScale::ratio_of_deviations, levels), bin.band);
        EXPECT_EQ(verdict == Verdict::fail, p < 1e-3) << value;
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

TEST(JudgeBins, FailsTogetherWhereNoBinFailsByItself) {
    BinEffects effects;
    for (int i = 0; i < 100; ++i) effects.bins.push_back(difference(3.5, 1, infinity, 1e-9));
    EXPECT_EQ(judge_bins(effects, Combination::holm, 1e-3, 0.05).verdict, Verdict::inconclusive);
    EXPECT_EQ(judge_bins(effects, Combination::simes, 1e-3, 0.05).verdict, Verdict::fail);
    EXPECT_EQ(judge_bins(effects, Combination::cauchy, 1e-3, 0.05).verdict, Verdict::fail);
}

TEST(CountScores, PutsWhatLiesBeyondIntoTheLastSteps) {
    const auto counts = count_scores({difference(100, 1, 1, 1), difference(-100, 1, 1, 1), difference(0.1, 1, 1, 1)});
    EXPECT_EQ(counts.front(), 1u);
    EXPECT_EQ(counts.back(), 1u);
    EXPECT_EQ(counts[counts.size() / 2], 1u);
}

}  // namespace
}  // namespace ff::studies
