#include "studies/analysis/bias.hpp"

#include "core/exact/exact.hpp"
#include "studies/analysis/analysis.hpp"
#include "tests/support/repetitions.hpp"
#include "tests/support/statistical_assertions.hpp"
#include "tests/support/studies.hpp"
#include "tests/unit/stats/samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace ff::studies {
namespace {

/// 64 points a pair of patches, in trials whose law may be anything.
constexpr std::string_view kernel_method =
    "[[method]]\nname = \"kernel\"\nsampler = \"sobol\"\nestimator = \"point_to_polygon\"\nsamples_per_patch = 64\n";

/// The same without a bound of the values.
constexpr std::string_view area_kernel_method =
    "[[method]]\nname = \"kernel\"\nsampler = \"sobol\"\nestimator = \"area_kernel\"\nsamples_per_patch = 64\n";

std::vector<double> shares_of_hits(std::size_t trials, int rays, double probability, double clumping) {
    std::mt19937_64 engine(7);
    std::vector<double> shares;
    for (std::size_t i = 0; i < trials; ++i) {
        const int hits = std::binomial_distribution<int>(static_cast<int>(rays / clumping), probability)(engine);
        shares.push_back(clumping * hits / rays);
    }
    return shares;
}

TEST(BinomialHits, AreCountedWhereTheirVarianceIsBinomial) {
    const auto shares = shares_of_hits(50, 1000, 0.2, 1);
    const auto counts = binomial_hits(shares, 1e-3);
    ASSERT_TRUE(counts);
    EXPECT_EQ(counts->trials, 50'000u);
    EXPECT_NEAR(static_cast<double>(counts->hits), 10'000, 600);
    EXPECT_EQ(binomial_hits(std::vector<double>(10, 0.0), 1e-3)->hits, 0u);
}

// Ten rays that always go the same way, or trials that are all alike.
TEST(BinomialHits, AreEmptyWhereRaysOrTrialsAreDependent) {
    EXPECT_FALSE(binomial_hits(shares_of_hits(50, 1000, 0.2, 10), 1e-3));
    EXPECT_FALSE(binomial_hits(std::vector<double>(10, 0.2), 1e-3));
}

TEST(BiasFinding, IsInconclusiveWhereOnlyStudentsTFindsADifference) {
    BiasFamily family;
    family.pairs = 15;
    family.adjusted_p = 0.2;
    family.student_p = 1e-4;
    EXPECT_EQ(bias_finding(family, 0.95), BiasFinding::inconclusive);
    family.untestable = 15;
    EXPECT_EQ(bias_finding(family, 0.95), BiasFinding::inconclusive);
    family.student_p = 0.2;
    EXPECT_EQ(bias_finding(family, 0.95), BiasFinding::untestable);
    family.adjusted_p = 1e-4;
    EXPECT_EQ(bias_finding(family, 0.95), BiasFinding::biased);
}

/// A study whose trials are off the exact factors by values of a law; those of F 1-2 are shifted.
template <class Law>
CellAnalysis study_of(Law law, std::uint64_t trials, std::uint64_t seed, double shift, std::string_view lines = "",
                      std::string_view method = kernel_method) {
    const StudyPlan plan =
        test::plan_of(test::study_text("trials = " + std::to_string(trials) + "\n" + std::string(lines), method));
    const auto exact = exact_form_factors(plan.scenes.front()).value();
    std::mt19937_64 engine(seed);
    return analyse_cell(test::fill(plan,
                                   [&](std::size_t, std::uint64_t, int from, int to) {
                                       return exact(from - 1, to - 1) +
                                              1e-3 * (law(engine) + (from == 1 && to == 2 ? shift : 0));
                                   }),
                        0);
}

CellAnalysis log_normal_study(std::uint64_t trials, std::uint64_t seed, double shift, std::string_view lines = "",
                              std::string_view method = kernel_method) {
    std::lognormal_distribution<double> law(0, 0.7);
    return study_of([&](auto& engine) { return law(engine) / std::exp(0.245) - 1; }, trials, seed, shift, lines,
                    method);
}

// Student's t calls a fifth to a half of these studies biased. Risks: false alarm 1e-6; .2 is noticed with power .99.
TEST(Bias, IsRarelyFoundInUnbiasedSkewedTrials) {
    constexpr std::uint64_t studies = 60;
    for (const std::uint64_t trials : {12u, 60u}) {
        std::uint64_t seed = 0;
        const auto biased = test::count_events(
            studies, [&] { return log_normal_study(trials, ++seed, 0).bias_finding == BiasFinding::biased; });
        EXPECT_TRUE(test::has_probability_at_most(biased, studies, 0.05, {.alpha = 1e-6, .detects = 0.35})) << trials;
    }
}

TEST(Bias, IsFoundInSkewedTrialsWhereItIsLarge) {
    const auto found = log_normal_study(100, 1, 500);
    EXPECT_EQ(found.bias_finding, BiasFinding::biased);
    EXPECT_EQ(found.bias->largest_pair, (Quantity{QuantityKind::form_factor, 1, 2}));
    // The values of this estimator lie between 0 and 1: the one that would explain the difference does not exist.
    EXPECT_FALSE(found.bias->unseen);
}

// One trial in ten is off by 6 standard deviations of the others: in forty trials, some of the thirty pairs have no
// such trial. Judged by their own trials alone, 30 % of these studies are called biased. Risks: false alarm 1e-6; .66
// (nightly .25) is noticed with power .99, and so is a bias of 8 standard errors that is found in fewer than .29 of
// them (nightly .7).
TEST(Bias, IsRarelyFoundWhereTheTrialsOfOtherPairsExplainIt) {
    const std::uint64_t studies = test::repetitions(24, 200);
    const double noticed = test::is_nightly() ? 0.2 : 0.61;
    const auto count = [&](double shift, bool alternating) {
        std::uint64_t seed = 0;
        return test::count_events(studies, [&] {
            std::normal_distribution<double> normal;
            std::bernoulli_distribution far(0.1);
            int values = 0;  // 30 in a trial, so that every second pair leans to the other side
            const auto law = [&](auto& engine) {
                const double value = 0.2 * (normal(engine) + (far(engine) ? 6 : 0) - 0.6);
                return alternating && values++ % 2 == 1 ? -value : value;
            };
            return study_of(law, 40, ++seed, shift).bias_finding == BiasFinding::biased;
        });
    };
    for (const bool alternating : {false, true})
        EXPECT_TRUE(
            test::has_probability_at_most(count(0, alternating), studies, 0.05, {.alpha = 1e-6, .detects = noticed}));
    EXPECT_TRUE(test::has_probability_at_least(count(8 * 0.2 * 2.06 / std::sqrt(40), false), studies, 0.9,
                                               {.alpha = 1e-6, .detects = noticed}));
}

TEST(Bias, IsInconclusiveWhereFewTrialsMayBeSkewed) {
    EXPECT_EQ(log_normal_study(10, 1, -20).bias_finding, BiasFinding::inconclusive);
}

TEST(Equivalence, IsNotShownByFewSkewedTrials) {
    EXPECT_EQ(log_normal_study(6, 1, 0, "equivalence_margin = 0.003").equivalence, EquivalenceFinding::inconclusive);
    EXPECT_EQ(log_normal_study(400, 1, 0, "equivalence_margin = 0.003").equivalence, EquivalenceFinding::shown);
}

// A margin of 0.003 with 400 trials: values that lie beyond it 1 / share times as far as the mean.
TEST(Equivalence, NamesTheValueThatAllTrialsMayHaveMissed) {
    const double share = 1 - std::pow(0.05, 1.0 / 400);
    const auto unbounded = log_normal_study(400, 1, 0, "equivalence_margin = 0.003", area_kernel_method);
    ASSERT_EQ(unbounded.equivalence, EquivalenceFinding::inconclusive);  // the variance is infinite on adjacent pairs
    const auto& unseen = unbounded.bias->unseen_beyond_margin;
    ASSERT_TRUE(unseen);
    EXPECT_NEAR(unseen->one_in, 1 / share, 1e-9);
    EXPECT_NEAR(std::abs(unseen->value - 0.2), 0.003 / share, 0.03);
    EXPECT_FALSE(log_normal_study(400, 1, 0, "equivalence_margin = 0.003").bias->unseen_beyond_margin);
    EXPECT_FALSE(log_normal_study(400, 1, 0, "", area_kernel_method).bias->unseen_beyond_margin);
}

TEST(POfAnyConstant, IsAttainedByTwoPointDistributions) {
    // Nine trials of ten are 0, the others 1.
    EXPECT_DOUBLE_EQ(p_of_any_constant(0, 0.1, 1, 3), 0.9 * 0.9);
    EXPECT_DOUBLE_EQ(p_of_any_constant(0.5, 0.25, 1, 3), 0.25) << "half of the trials are 0";
    EXPECT_EQ(p_of_any_constant(0, 0.1, std::numeric_limits<double>::infinity(), 30), 1);
    EXPECT_EQ(p_of_any_constant(0, 0, 1, 30), 1);
}

TEST(POfConstant, BoundsAllUnimodalLaws) {
    EXPECT_EQ(p_of_constant(1.0 / 256, 1.0 / 256, 50), 1);
    EXPECT_EQ(p_of_constant(0, std::nullopt, 50), 1);
    EXPECT_DOUBLE_EQ(p_of_constant(-2.5 / 256, 1.0 / 256, 3), 1.0 / 9);
    EXPECT_DOUBLE_EQ(p_of_constant(1e-3, std::nullopt, 11), 0x1p-10);
}

}  // namespace
}  // namespace ff::studies
