#include "studies/diagnostics/coverage.hpp"

#include "core/exact/exact.hpp"
#include "studies/diagnostics/variances.hpp"
#include "tests/support/statistical_assertions.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace ff::studies {
namespace {

/// Normal trials around the exact value, off by `bias` standard deviations.
Store trials_around_exact(const StudyPlan& plan, double bias, double deviation_of_second = 0.01) {
    const auto exact = *exact_form_factors(plan.scenes.front());
    return test::fill(plan, [=](std::size_t cell, std::uint64_t trial, int from, int to) {
        std::seed_seq seed{static_cast<int>(cell), static_cast<int>(trial), from, to};
        std::mt19937_64 engine(seed);
        const double deviation = cell == 0 ? 0.01 : deviation_of_second;
        return exact(from - 1, to - 1) + deviation * (bias + std::normal_distribution<double>()(engine));
    });
}

StudyPlan coverage_plan() {
    return test::plan_of(test::study_text("trials = 1500", R"([[method]]
name = "a"
sampler = "sobol"
estimator = "point_to_polygon"
samples_per_patch = 16
[coverage]
replicates = [5]
)"));
}

const Coverage& row(const std::vector<Coverage>& rows, IntervalRule rule) {
    return *std::find_if(rows.begin(), rows.end(), [&](const Coverage& r) { return r.interval_method == rule; });
}

// 300 groups of 5 from each of 6 faces. Risks: 1e-6; .90 is noticed with power .99.
TEST(Coverage, IsNominalOnNormalTrialsForStudentAndTwoStageOnly) {
    const auto rows = measure_coverage(trials_around_exact(coverage_plan(), 0));
    const auto agrees = [&](IntervalRule rule) {
        const Coverage& found = row(rows, rule);
        return test::has_probability(found.covered, found.intervals, 0.95,
                                     {.detects = found.intervals > 1000 ? 0.05 : 0.13});
    };
    EXPECT_EQ(row(rows, IntervalRule::student_t).intervals, 1800u);
    EXPECT_TRUE(agrees(IntervalRule::student_t));
    EXPECT_TRUE(agrees(IntervalRule::two_stage));
    EXPECT_FALSE(agrees(IntervalRule::normal));
    EXPECT_FALSE(agrees(IntervalRule::percentile_bootstrap));
    EXPECT_TRUE(row(rows, IntervalRule::normal).short_of_nominal);
    EXPECT_FALSE(row(rows, IntervalRule::student_t).short_of_nominal);
    EXPECT_NEAR(row(rows, IntervalRule::two_stage).mean_trials, 20, 2);
    EXPECT_TRUE(row(rows, IntervalRule::normal).coverage_interval.contains(row(rows, IntervalRule::normal).share()));
}

TEST(Coverage, FallsShortWhereThereIsABias) {
    const auto rows = measure_coverage(trials_around_exact(coverage_plan(), 1));
    EXPECT_TRUE(row(rows, IntervalRule::student_t).short_of_nominal);
}

TEST(VarianceReduction, IsTheRatioOfVariances) {
    const StudyPlan plan = test::plan_of(test::study_text("trials = 400", R"([[method]]
name = "random"
sampler = "random"
estimator = "point_to_polygon"
samples_per_patch = 16
[[method]]
name = "other"
sampler = "sobol"
estimator = "point_to_polygon"
samples_per_patch = 16
[[method]]
name = "another size"
sampler = "sobol"
estimator = "point_to_polygon"
samples_per_patch = 32
)"));
    const Store store = trials_around_exact(plan, 0, 0.005);
    const auto found = compare_with_random(analyse(store));
    ASSERT_EQ(found.size(), 2u);  // the classes of "other"
    for (const VarianceReduction& reduction : found) {
        EXPECT_EQ(reduction.cell, 1u);
        EXPECT_EQ(reduction.random_cell, 0u);
        EXPECT_TRUE(reduction.interval.contains(4)) << reduction.factor;
        EXPECT_FALSE(reduction.interval.contains(3));
    }
}

}  // namespace
}  // namespace ff::studies
