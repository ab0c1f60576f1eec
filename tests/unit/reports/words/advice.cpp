#include "reports/words/findings/advice.hpp"

#include "reports/words/findings/coverage_words.hpp"
#include "reports/words/findings/occlusion_words.hpp"
#include "tests/support/studies.hpp"
#include "tests/unit/reports/small_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace ff::reports {
namespace {

using testing::ElementsAre;

const studies::StudyPlan& plan() {
    return test::published_results().findings.plan;
}

RankedMethod method(std::string label, double value) {
    RankedMethod made;
    made.label = std::move(label);
    made.value = value;
    made.interval = stats::Interval{value - 1, value + 1, 0.95, "", 0};
    return made;
}

/// A ranking of a, b and c, with values 2, 3 and 9.
Ranking ranking(PairClass pair_class, std::vector<std::string> leaders) {
    return {.methods = {method("a", 2), method("b", 3), method("c", 9)},
            .pair_class = pair_class,
            .leaders = std::move(leaders)};
}

TEST(Advice, NamesMethodsAmongTheBestOnAllPairs) {
    const std::vector<Ranking> rankings{ranking(PairClass::parallel, {"a", "b"}),
                                        ranking(PairClass::adjacent, {"b", "a", "c"})};
    EXPECT_THAT(
        advice(plan(), rankings, errs_less),
        ElementsAre("take a or b: on parallel and adjacent pairs nothing is shown to err less (RMSE between 1 and 4)"));
}

TEST(Advice, NamesTheMarginsOfASingleBestMethod) {
    Ranking first = ranking(PairClass::parallel, {"a"});
    first.margin = "errs 2 times less than b (1 to 3)";
    first.again = "2 times (1 to 3)";
    Ranking second = ranking(PairClass::adjacent, {"a"});
    second.again = "4 times (3 to 5)";
    EXPECT_THAT(advice(plan(), {first, second}, errs_less),
                ElementsAre("take a: on parallel pairs it errs 2 times less than b (1 to 3)",
                            "on adjacent pairs 4 times (3 to 5)"));
}

TEST(Advice, SpeaksOfEachClassWhereNoMethodIsBestOnAll) {
    Ranking exact = ranking(PairClass::parallel, {"a"});
    exact.methods.front().value.reset();
    exact.margin = "is exact";
    EXPECT_THAT(advice(plan(), {exact, ranking(PairClass::adjacent, {"b", "c"})}, errs_less),
                ElementsAre("on adjacent pairs take b or c: nothing is shown to err less (RMSE between 2 and 10)",
                            "on parallel pairs a is exact"));
}

TEST(Advice, NamesNoMethodWhereNothingIsShown) {
    EXPECT_THAT(advice(plan(), {ranking(PairClass::parallel, {}), ranking(PairClass::adjacent, {})}, errs_less),
                ElementsAre("on parallel and adjacent pairs no method is shown to err less than another"));
    EXPECT_THAT(
        advice(plan(), {ranking(PairClass::parallel, {}), ranking(PairClass::adjacent, {"a", "b"})}, varies_less),
        ElementsAre("take a or b: on parallel and adjacent pairs nothing is shown to vary less (between 1 and 4 times "
                    "less than "
                    "random points)"));
}

TEST(Advice, RecommendsSlopesForConvergenceAlone) {
    EXPECT_THAT(advice(plan(), {ranking(PairClass::parallel, {"a", "b"})}, converges_faster),
                ElementsAre("for the fastest convergence take a or b: slope 1 to 4 on parallel pairs"));
    Ranking many = ranking(PairClass::parallel, {"a", "b", "c", "d"});
    many.methods.push_back(method("d", 4));
    EXPECT_THAT(advice(plan(), {many}, converges_faster),
                ElementsAre("for the fastest convergence take a (3 more are not shown to differ): slope 1 to 3 on "
                            "parallel pairs"));
}

TEST(Advice, SaysLessWhereRoomIsShort) {
    Ranking first = ranking(PairClass::parallel, {"a"});
    first.margin = "errs 2 times less than b (1 to 3)";
    first.cost = " with 9 times fewer evaluations";
    const std::vector<Ranking> rankings{first, ranking(PairClass::adjacent, {"b"})};
    EXPECT_EQ(advice(plan(), rankings, errs_less).front(),
              "on parallel pairs a errs 2 times less than b (1 to 3) with 9 times fewer evaluations");
    EXPECT_EQ(advice(plan(), rankings, errs_less, Words::with_margin).front(),
              "on parallel pairs a errs 2 times less than b (1 to 3)");
    EXPECT_THAT(advice(plan(), rankings, errs_less, Words::names_alone),
                ElementsAre("on parallel pairs take a", "on adjacent pairs take b"));
}

TEST(Advice, GivesTheWholeRangeOfMarginsWhereRoomIsShort) {
    Ranking first = ranking(PairClass::parallel, {"a"});
    first.margin = "errs 2 times less than b (1.5 to 3)";
    first.ahead = {1.5, 3};
    Ranking second = ranking(PairClass::adjacent, {"a"});
    second.margin = "errs 4 times less than b (2 to 5)";
    second.ahead = {2, 5};
    EXPECT_THAT(advice(plan(), {first, second}, errs_less, Words::names_alone),
                ElementsAre("take a: it errs 1.5 to 5 times less than the next on parallel and adjacent pairs"));
    for (Ranking* each : {&first, &second}) {
        for (RankedMethod& row : each->methods) row.size = "1 × 4096 rays";
    }
    EXPECT_THAT(
        advice(plan(), {first, second}, errs_less, Words::names_alone),
        ElementsAre("take a: at 4096 rays it errs 1.5 to 5 times less than the next on parallel and adjacent pairs"));
    second.ahead.reset();
    EXPECT_THAT(
        advice(plan(), {first, second}, errs_less, Words::names_alone),
        ElementsAre("take a: on parallel and adjacent pairs nothing is shown to err less (RMSE between 1 and 3)"));
}

TEST(Advice, KeepsSizesApart) {
    Ranking few = ranking(PairClass::parallel, {"a", "b"});
    few.at = " with 64 rays";
    Ranking many = ranking(PairClass::parallel, {"b", "c"});
    many.at = " with 625 rays";
    EXPECT_THAT(
        advice(plan(), {few, many}, errs_less),
        ElementsAre(
            "take a or b with 64 rays: on parallel pairs nothing is shown to err less (RMSE between 1 and 4)",
            "take b or c with 625 rays: on parallel pairs nothing is shown to err less (RMSE between 2 and 10)"));
}

studies::Coverage row(studies::IntervalRule rule, std::uint64_t replicates, std::uint64_t covered, bool is_short) {
    studies::Coverage row;
    row.interval_method = rule;
    row.replicates = replicates;
    row.intervals = 1000;
    row.covered = covered;
    row.short_of_nominal = is_short;
    row.coverage_interval.low = 0.92;
    row.coverage_interval.high = 0.96;
    return row;
}

/// A partly occluded pair on which the first of two methods errs least, or the second where the first has no variance.
studies::HiddenPair hidden_pair(const studies::StudyPlan& plan, bool first_is_infinite) {
    studies::HiddenPair pair;
    pair.hidden = 0.5;
    pair.exact = 0.1;
    pair.methods.assign(plan.spec.methods.size(), studies::PairError{});
    pair.least = first_is_infinite ? 1 : 0;
    pair.decided = true;
    if (first_is_infinite) pair.methods[0]->error.status = studies::VarianceStatus::infinite;
    return pair;
}

TEST(OcclusionAdvice, NamesAnotherMethodWhereTheVarianceIsInfinite) {
    studies::StudyResults results = test::published_results();
    const studies::StudyPlan& plan = results.findings.plan;
    const std::string first = plan.spec.methods[0].name;
    const std::string second = plan.spec.methods[1].name;
    results.occlusion.emplace_back().scenes = {hidden_pair(plan, false), hidden_pair(plan, false),
                                               hidden_pair(plan, true)};
    EXPECT_EQ(occlusion_advice(results), "at about equal samples take " + first +
                                             " on partly occluded pairs (errs least on 2 of 3); " +
                                             "where its variance is infinite, " + second);
    results.occlusion.front().scenes.back().decided = false;
    EXPECT_THAT(occlusion_advice(results), testing::Not(testing::HasSubstr(second)));
    // One win of many recommends nothing.
    auto& pairs = results.occlusion.front().scenes;
    pairs[1].decided = false;
    EXPECT_EQ(occlusion_advice(results),
              "no method is shown to err least on most of 3 partly occluded pairs (" + first + " on 1)");
    pairs[0].decided = false;
    EXPECT_EQ(occlusion_advice(results), "no method is shown to err least on any of 3 partly occluded pairs");
}

TEST(CoverageAdvice, RecommendsTheRuleNowhereShortWithTheFewestReplicates) {
    using studies::IntervalRule;
    studies::StudyResults results = test::published_results();
    results.findings.plan.spec.coverage = {5, 10};
    results.coverage = {row(IntervalRule::student_t, 5, 880, true), row(IntervalRule::student_t, 10, 940, false),
                        row(IntervalRule::normal, 5, 710, true), row(IntervalRule::normal, 10, 850, true)};
    EXPECT_EQ(
        coverage_advice(results),
        "from 10 replicates on take Student's t: at worst its 95 % intervals hold in 94.0 % of runs (92.0 to 96.0); "
        "normal quantiles in 85.0 % (92.0 to 96.0)");
    results.coverage[1].covered = 900;
    EXPECT_THAT(coverage_advice(results), testing::StartsWith("no rule is shown to keep its 95 %"));
    results.coverage[1] = row(IntervalRule::student_t, 10, 12, false);
    results.coverage[1].intervals = 12;  // nothing is missing, and nothing is known
    EXPECT_THAT(coverage_advice(results), testing::StartsWith("no rule is shown to keep its 95 %"));
}

}  // namespace
}  // namespace ff::reports
