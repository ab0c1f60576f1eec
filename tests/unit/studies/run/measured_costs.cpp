#include "studies/run/measured_costs.hpp"

#include "tests/support/studies.hpp"

#include <gtest/gtest.h>

namespace ff::studies {
namespace {

constexpr const char* methods = R"([[method]]
name = "A"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = 100
[[method]]
name = "B"
sampler = "random"
estimator = "ray_shooting"
completion = "reciprocal"
samples_per_patch = 100
[[method]]
name = "C"
sampler = "random"
estimator = "ray_shooting"
tracer = "embree"
samples_per_patch = 100
)";

RunProgress of_unit(std::size_t unit, double seconds, double squares) {
    RunProgress progress;
    progress.unit = unit;
    progress.processor_seconds = seconds;
    progress.processor_seconds_squared = squares;
    return progress;
}

TEST(MeasuredCosts, AreReadAgainFromTheContextOfSeveralRuns) {
    const auto plan = test::plan_of(test::study_text("trials = 4", methods));
    ASSERT_EQ(plan.units.size(), 3u);
    MeasuredCosts first(plan);
    first.add(of_unit(0, 4, 4.5));
    MeasuredCosts second(plan);
    second.add(of_unit(1, 8, 18));  // the same rays, completed otherwise: the same cost
    second.add(of_unit(2, 0, 0));   // not measured
    Context context;
    add_context(context, {{std::string(costs_key), first.in_context()}});
    add_context(context, {{std::string(costs_key), second.in_context()}});
    const auto costs = measured_costs(plan, context);
    ASSERT_TRUE(costs[0] && costs[1]);
    EXPECT_EQ(costs[0]->trials, 8u);
    EXPECT_DOUBLE_EQ(costs[0]->mean(), 1.5);
    // Variance (22.5 - 8 * 1.5^2) / 7 = 9/14; of the mean of 8 that over 8. The machine's 10 %, and 1 ms in 12 s.
    EXPECT_NEAR(costs[0]->relative_error(), std::hypot(std::sqrt(9.0 / 14 / 8) / 1.5, 0.1, 1e-3 / 12), 1e-12);
    EXPECT_EQ(costs[1]->trials, 8u);
    EXPECT_FALSE(costs[2]);
}

TEST(MeasuredCosts, AreEmptyForAnEmptyOrMalformedContext) {
    const auto plan = test::plan_of(test::study_text("trials = 4", methods));
    for (const char* text : {"", "a", "a:1:2", "::::", "a:-1:x:y"}) {
        for (const auto& cost : measured_costs(plan, {{std::string(costs_key), text}})) EXPECT_FALSE(cost) << text;
    }
}

TEST(MeasuredCosts, AreMeasuredByARun) {
    const auto plan = test::plan_of(test::study_text("trials = 4", methods));
    Store store = Store::create_or_resume(test::in_memory, plan);
    MeasuredCosts costs(plan);
    RunOptions options;
    options.report = [&](const RunProgress& progress) { costs.add(progress); };
    run_study(store, options);
    for (const auto& cost : measured_costs(plan, {{std::string(costs_key), costs.in_context()}})) {
        ASSERT_TRUE(cost);
        EXPECT_GT(cost->mean(), 0);
        EXPECT_LT(cost->mean(), 10);
    }
}

}  // namespace
}  // namespace ff::studies
