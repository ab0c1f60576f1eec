#include "tests/validation/gates/selftest.hpp"

#include "stats/basics/moments.hpp"
#include "studies/run/parallel.hpp"
#include "tests/support/statistical_assertions.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ff::studies::gates {
namespace {

constexpr double level = 0.999;

TEST(MeasuredRate, HoldsWhereTheIntervalAllowsTheClaim) {
    const stats::Proportion half{.hits = 500, .trials = 1000};
    EXPECT_TRUE(holds({"", half, RateClaim::equal, 0.52}, level));
    EXPECT_FALSE(holds({"", half, RateClaim::equal, 0.6}, level));
    EXPECT_FALSE(holds({"", half, RateClaim::equal, 0.4}, level));
    EXPECT_FALSE(holds({"", half, RateClaim::at_least, 0.6}, level));
    EXPECT_TRUE(holds({"", half, RateClaim::at_least, 0.4}, level));
    EXPECT_FALSE(holds({"", half, RateClaim::at_most, 0.4}, level));
    EXPECT_TRUE(holds({"", half, RateClaim::at_most, 0.6}, level));
    EXPECT_TRUE(holds({"", half, RateClaim::none, 0}, level));
}

TEST(MeasuredRate, HasASmallerTailTheLessItAgreesWithTheClaim) {
    const auto tail = [](RateClaim claim, std::uint64_t hits) { return tail_of({"", {hits, 1000}, claim, 0.5}); };
    EXPECT_LT(tail(RateClaim::at_most, 510), tail(RateClaim::at_most, 490));
    EXPECT_LT(tail(RateClaim::at_least, 490), tail(RateClaim::at_least, 510));
    EXPECT_LT(tail(RateClaim::equal, 520), tail(RateClaim::equal, 490));
    EXPECT_LT(tail(RateClaim::equal, 480), tail(RateClaim::equal, 510));
    EXPECT_LT(tail(RateClaim::at_least, 1000), tail(RateClaim::none, 0));
}

TEST(Repetitions, DoNotDependOnThreads) {
    const auto draw = [](stats::Draws& draws) { return draw_normal(draws); };
    const auto one = Repetitions{Seed{7}, 1}.collect(500, "x", draw);
    EXPECT_EQ(one, (Repetitions{Seed{7}, 3}.collect(500, "x", draw)));
    EXPECT_NE(one, (Repetitions{Seed{8}, 1}.collect(500, "x", draw)));
    EXPECT_NE(one, (Repetitions{Seed{7}, 1}.collect(500, "y", draw)));
}

TEST(Repetitions, DrawFromTheNamedDistributions) {
    const Repetitions repetitions{Seed{7}, 2};
    const auto normal = repetitions.collect(20'000, "n", [](stats::Draws& draws) { return draw_normal(draws); });
    EXPECT_TRUE(test::unbiased(normal, 0, {.alpha = 1e-6, .detects = 0.06}));
    EXPECT_NEAR(*stats::moments_of(normal).variance(), 1, 0.06);  // six standard errors
    const auto waits = repetitions.collect(20'000, "e", [](stats::Draws& draws) { return draw_exponential(draws); });
    EXPECT_TRUE(test::unbiased(waits, 1, {.alpha = 1e-6, .detects = 0.06}));
}

TEST(Repetitions, PropagateExceptionsOfTasks) {
    const auto task = [](std::uint64_t i) {
        if (i == 5) throw std::runtime_error("five");
    };
    EXPECT_THROW(for_each_index(100, 3, task), std::runtime_error);
}

TEST(Selftest, CountsClaimsThatDoNotHold) {
    Selftest selftest;
    selftest.level = level;
    EXPECT_EQ(selftest.contradictions(), 0u);
    selftest.coverage.rates = {{"right", {.hits = 950, .trials = 1000}, RateClaim::equal, 0.95},
                               {"wrong", {.hits = 900, .trials = 1000}, RateClaim::equal, 0.95}};
    selftest.calibration.p_values = {{"not uniform", 1000, 0.2, 1e-9}};
    EXPECT_EQ(selftest.contradictions(), 2u);
}

}  // namespace
}  // namespace ff::studies::gates
