#include "studies/analysis/slopes.hpp"

#include "core/exact/exact.hpp"
#include "studies/analysis/analysis.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace ff::studies {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

StudyPlan ladder_plan(std::string_view sampler, std::string_view estimator,
                      std::string_view sizes = "[64, 256, 1024, 4096]") {
    return test::plan_of(test::study_text("trials = 40", fmt::format(R"([[method]]
name = "a"
sampler = "{}"
estimator = "{}"
samples_per_patch = {}
)",
                                                                     sampler, estimator, sizes)));
}

/// Errors of size N^rate: normal, with a part that all pairs of a trial share.
Store store_with_rate(const StudyPlan& plan, double rate, double shared) {
    const auto exact = *exact_form_factors(plan.scenes.front());
    return test::fill(plan, [=, &plan](std::size_t cell, std::uint64_t trial, int from, int to) {
        const auto normal = [&](int a, int b) {
            std::seed_seq seed{static_cast<int>(cell), static_cast<int>(trial), a, b};
            std::mt19937_64 engine(seed);
            return std::normal_distribution<double>()(engine);
        };
        const double size = std::pow(static_cast<double>(plan.cells[cell].samples_per_patch), rate);
        return exact(from - 1, to - 1) + 0.1 * size * (shared * normal(0, 0) + (1 - shared) * normal(from, to));
    });
}

std::vector<LadderSlopes> slopes_of(const Store& store) {
    return fit_slopes(store, analyse(store));
}

TEST(Slopes, NeedThreeSizesOfOneMethod) {
    const auto two = ladder_plan("sobol", "area_kernel", "[64, 128]");
    EXPECT_THAT(slopes_of(store_with_rate(two, -1, 0)), IsEmpty());
}

TEST(Slopes, MatchTheRateOfTheErrors) {
    const auto found = slopes_of(store_with_rate(ladder_plan("halton", "area_kernel"), -1, 0));
    ASSERT_THAT(found, SizeIs(1));
    ASSERT_THAT(found.front().classes, SizeIs(2));
    EXPECT_THAT(found.front().pairs, SizeIs(60));
    const ClassSlopes& parallel = found.front().classes.front();
    EXPECT_EQ(parallel.pair_class, PairClass::parallel);
    EXPECT_EQ(parallel.pairs, 6u);
    EXPECT_TRUE(parallel.rmse.interval->contains(-1));
    EXPECT_TRUE(parallel.rmse.interval_from_fit->contains(-1));
    EXPECT_TRUE(parallel.median.interval->contains(-1));
    EXPECT_EQ(parallel.finding, RateFinding::as_expected);
}

// Correlation 1: six pairs say no more than one, so the interval must be as wide.
TEST(Slopes, AllowForCorrelatedPairsOfAClass) {
    const auto plan = ladder_plan("halton", "area_kernel");
    const auto apart = slopes_of(store_with_rate(plan, -1, 0));
    const auto together = slopes_of(store_with_rate(plan, -1, 1));
    const Slope& class_slope = together.front().classes.front().rmse;
    const auto& pairs = together.front().pairs;
    const Slope& pair_slope = *std::find_if(pairs.begin(), pairs.end(), [](const Slope& slope) {
        return slope.pair_class == PairClass::parallel && slope.statistic == ErrorSize::rmse;
    });
    EXPECT_NEAR(class_slope.interval->width() / pair_slope.interval->width(), 1, 0.1);
    EXPECT_NEAR(class_slope.interval_from_fit->width() / pair_slope.interval_from_fit->width(), 1, 0.1);
    EXPECT_LT(apart.front().classes.front().rmse.interval->width(), 0.7 * class_slope.interval->width());
}

// The bootstrap of five trials alone holds in 86 %, of a hundred in 94 %.
TEST(Slopes, HaveIntervalsThatCoverThoseOfTheFit) {
    for (const int trials : {5, 100}) {
        const auto plan = test::plan_of(test::study_text(fmt::format("trials = {}", trials), R"([[method]]
name = "a"
sampler = "halton"
estimator = "area_kernel"
samples_per_patch = [64, 256, 1024, 4096]
)"));
        const ClassSlopes found = slopes_of(store_with_rate(plan, -1, 0)).front().classes.front();
        EXPECT_LE(found.rmse.interval->low, found.rmse.interval_from_fit->low);
        EXPECT_GE(found.rmse.interval->high, found.rmse.interval_from_fit->high);
        EXPECT_EQ(found.rmse.interval->method, "bootstrap_and_wls");
        EXPECT_EQ(found.median.interval->method, "percentile_bootstrap");
    }
}

TEST(Slopes, UseOnlyTheMedianUnderInfiniteVariance) {
    const auto found = slopes_of(store_with_rate(ladder_plan("random", "area_kernel"), -1.0 / 3, 0));
    const ClassSlopes& adjacent = found.front().classes.back();
    EXPECT_EQ(adjacent.pair_class, PairClass::adjacent);
    EXPECT_FALSE(adjacent.rmse.slope);
    EXPECT_EQ(adjacent.sizes.front().status, VarianceStatus::infinite);
    EXPECT_FALSE(adjacent.sizes.front().efficiency);
    EXPECT_TRUE(adjacent.median.interval->contains(-1.0 / 3));
    EXPECT_EQ(adjacent.finding, RateFinding::as_expected);
}

// Errors that fall as N^-0.3 under a sampler whose theory says N^-0.5, and the other way round.
TEST(Slopes, AreFoundToDifferFromTheory) {
    const auto slow =
        slopes_of(store_with_rate(ladder_plan("random", "ray_shooting", "[1024, 4096, 16384, 65536]"), -0.3, 0));
    EXPECT_EQ(slow.front().classes.front().finding, RateFinding::slower);
    EXPECT_LT(*slow.front().classes.front().adjusted_p, 1e-6);
    const auto fast = slopes_of(store_with_rate(ladder_plan("random", "area_kernel"), -0.9, 0));
    EXPECT_EQ(fast.front().classes.front().finding, RateFinding::faster);
}

TEST(Slopes, AreAsExpectedWhenFasterThanABound) {
    const auto found =
        slopes_of(store_with_rate(ladder_plan("sobol", "ray_shooting", "[1024, 4096, 16384, 65536]"), -0.8, 0));
    EXPECT_TRUE(found.front().classes.front().rmse.expected->at_least);
    EXPECT_EQ(found.front().classes.front().finding, RateFinding::as_expected);
}

// A method that is exact at all sizes was called the slowest, with a slope of 0.
TEST(Slopes, AreEmptyWhereErrorsAreRounding) {
    const auto plan = ladder_plan("sobol", "control_variate");
    const auto exact = *exact_form_factors(plan.scenes.front());
    const auto found = slopes_of(test::fill(plan, [&](std::size_t cell, std::uint64_t, int from, int to) {
        return exact(from - 1, to - 1) + (cell == 3 ? 2e-16 : 1e-15);
    }));
    for (const ClassSlopes& of_class : found.at(0).classes) {
        EXPECT_FALSE(of_class.rmse.slope);
        EXPECT_FALSE(of_class.median.slope);
        EXPECT_EQ(of_class.finding, RateFinding::no_slope);
    }
}

TEST(Slopes, HaveNoIntervalForDeterministicMethods) {
    const auto found = slopes_of(store_with_rate(ladder_plan("sobol_raw", "area_kernel"), -1, 0));
    const ClassSlopes& parallel = found.front().classes.front();
    EXPECT_TRUE(parallel.rmse.slope);
    EXPECT_FALSE(parallel.rmse.interval);
    EXPECT_EQ(parallel.finding, RateFinding::no_slope);
}

TEST(Ladders, AreDistinguishedBySubdivision) {
    const auto plan = test::plan_of(test::study_text("trials = 2", R"([[method]]
name = "a"
sampler = "random"
estimator = "ray_shooting"
patches_per_face = [1, 4]
samples_per_patch = [10, 20, 40]
[[method]]
name = "b"
sampler = "random"
estimator = "ray_shooting"
patches_per_face = [1, 9, 4]
samples_per_patch = 10
)"));
    const auto ladders = find_ladders(plan);
    ASSERT_THAT(ladders, SizeIs(3));
    EXPECT_EQ(ladders[0].label, "a (1 patches)");
    EXPECT_EQ(ladders[1].label, "a (4 patches)");
    EXPECT_EQ(ladders[2].label, "b");
    EXPECT_EQ(ladders[2].growth, Growth::patches);
    EXPECT_THAT(ladders[2].cells, testing::ElementsAre(6, 8, 7));
}

TEST(ExpectedRate, IsSlowedByItsLogarithmicFactors) {
    Method method;
    method.sampler = "sobol";
    method.estimator = "area_kernel";
    const auto expected = expected_rate(method, PairClass::parallel);
    EXPECT_EQ(expected->rate, -1.5);
    // d ln(N^-3/2 (ln N)^3/2) / d ln N at N = e^10
    EXPECT_NEAR(expected->slowest(std::exp(10.0)), -1.5 + 0.15, 1e-12);
    EXPECT_FALSE(expected_rate(method, PairClass::adjacent));
}

TEST(ExpectedRate, IsThatOfJumpsForAKernelThatMayBeOccluded) {
    Method method;
    method.sampler = "sobol";
    method.estimator = "area_kernel";
    const auto net = expected_rate(method, PairClass::parallel, Hiding::possible);
    EXPECT_DOUBLE_EQ(net->rate, -0.5 - 1.0 / 14);
    EXPECT_TRUE(net->at_least);
    method.sampler = "stratified";
    EXPECT_DOUBLE_EQ(expected_rate(method, PairClass::parallel, Hiding::possible)->rate, -0.625);
    EXPECT_DOUBLE_EQ(expected_rate(method, PairClass::parallel, Hiding::none)->rate, -0.75);
    // Points that are tested one by one are not graded: there is no variance, and the rate is that of the median.
    method.sampler = "random";
    method.map = PointMap::graded;
    EXPECT_TRUE(expected_rate(method, PairClass::adjacent, Hiding::possible)->of_median);
    EXPECT_FALSE(expected_rate(method, PairClass::adjacent, Hiding::none)->of_median);
    // That rate is a limit, which few points may not have come near to.
    EXPECT_EQ(expected_rate(method, PairClass::adjacent, Hiding::possible)->slowest(64), 0);
}

}  // namespace
}  // namespace ff::studies
