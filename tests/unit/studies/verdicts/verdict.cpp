#include "studies/verdicts/verdict.hpp"

#include "studies/verdicts/gate.hpp"
#include "studies/verdicts/gate_result.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace ff::studies::gates {
namespace {

constexpr Band unit_band{-1, 1};

Measurement between(double low, double high, double failing_low, double failing_high) {
    Measurement measurement;
    measurement.value = (low + high) / 2;
    measurement.passing = {.low = low, .high = high, .level = 0.9, .method = "made up", .n = 2};
    measurement.failing = {.low = failing_low, .high = failing_high, .level = 0.9999, .method = "made up", .n = 2};
    return measurement;
}

TEST(Judge, PassesWhereThePassingIntervalLiesInside) {
    EXPECT_EQ(judge(between(-0.5, 0.5, -2, 2), unit_band), Verdict::pass);
    EXPECT_EQ(judge(between(-0.5, 1.1, -2, 2), unit_band), Verdict::inconclusive);
    EXPECT_EQ(judge(between(-1.1, 0.5, -2, 2), unit_band), Verdict::inconclusive);
}

TEST(Judge, FailsOnlyWhereTheFailingIntervalLiesWhollyOutside) {
    EXPECT_EQ(judge(between(1.2, 1.4, 1.1, 1.5), unit_band), Verdict::fail);
    EXPECT_EQ(judge(between(-1.4, -1.2, -1.5, -1.1), unit_band), Verdict::fail);
    // Outside by the passing interval, but not by the adjusted one: no failure yet.
    EXPECT_EQ(judge(between(1.2, 1.4, 0.9, 1.5), unit_band), Verdict::inconclusive);
}

TEST(Judge, NeverPassesWithoutEvidence) {
    EXPECT_EQ(judge(std::nullopt, unit_band), Verdict::inconclusive);
    EXPECT_EQ(verdict_of({}), Verdict::inconclusive);
}

TEST(Judge, AcceptsBandsWithOneEnd) {
    const Band upwards{0.9, std::numeric_limits<double>::infinity()};
    EXPECT_EQ(judge(between(5, 6, 4, 7), upwards), Verdict::pass);
    EXPECT_EQ(judge(between(0.5, 0.6, 0.4, 0.7), upwards), Verdict::fail);
}

TEST(VerdictOf, IsTheWorstOfAll) {
    const auto gate = [](std::initializer_list<Verdict> verdicts) {
        std::vector<Comparison> comparisons;
        for (const Verdict verdict : verdicts) comparisons.emplace_back().verdict = verdict;
        return comparisons;
    };
    using enum Verdict;
    EXPECT_EQ(verdict_of(gate({pass, pass})), pass);
    EXPECT_EQ(verdict_of(gate({pass, inconclusive})), inconclusive);
    EXPECT_EQ(verdict_of(gate({inconclusive, fail, pass})), fail);
    EXPECT_EQ(decisive(gate({inconclusive, fail, pass})).verdict, fail);
}

TEST(LevelsOf, SplitAlphaAmongAllTestsAndPassingAlphaAmongLooks) {
    Spec spec;
    spec.alpha = 0.12;
    spec.looks = 2;
    spec.gates.resize(3);
    const Levels levels = levels_of(spec, 10);
    EXPECT_DOUBLE_EQ(levels.fail_alpha, 0.12 / 60);
    EXPECT_DOUBLE_EQ(levels.pass_alpha, 0.025);
    EXPECT_EQ(levels.power, spec.power);
}

}  // namespace
}  // namespace ff::studies::gates
