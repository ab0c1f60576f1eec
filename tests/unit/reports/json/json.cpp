#include "reports/json/json.hpp"
#include "reports/json/context_json.hpp"

#include "tests/unit/reports/small_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace ff::reports {
namespace {

using nlohmann::json;

const json& small() {
    static const json parsed = json::parse(results_json(test::small_results()));
    return parsed;
}

TEST(ResultsJson, NamesItsSchema) {
    EXPECT_EQ(small().at("schema"), "ffstudy.results/" + std::to_string(results_json_version));
    EXPECT_EQ(small().at("study"), "small, with a comma");
    EXPECT_EQ(small().at("seed"), 1);
    EXPECT_EQ(small().at("complete"), true);
    EXPECT_EQ(small().at("published"), nullptr);
}

TEST(ResultsJson, HasACellForEverySizeAndASummaryForEveryQuantity) {
    ASSERT_EQ(small().at("cells").size(), 14u);
    for (const json& cell : small().at("cells")) EXPECT_EQ(cell.at("summaries").size(), 37u);
}

TEST(ResultsJson, WritesNullForWhatDoesNotExist) {
    for (const json& cell : small().at("cells")) {
        const bool deterministic = cell.at("deterministic");
        EXPECT_EQ(cell.at("bias_test").is_null(), deterministic);
        for (const json& s : cell.at("summaries")) {
            EXPECT_TRUE(s.at("mean").is_number());
            if (deterministic) {
                EXPECT_TRUE(s.at("std").is_null() && s.at("bias_interval").is_null());
            }
            EXPECT_EQ(s.at("variance") == "none", deterministic);
            if (s.at("variance") == "infinite") {
                EXPECT_TRUE(s.at("bias_interval").is_null());
            }
        }
    }
}

TEST(ResultsJson, StatesBothRisksOfTheBiasTest) {
    const json& test = small().at("cells").at(0).at("bias_test");
    EXPECT_EQ(test.at("pairs"), 15);
    EXPECT_NEAR(test.at("alpha"), 0.05, 1e-12);
    EXPECT_EQ(test.at("power"), 0.9);
    EXPECT_GT(test.at("minimum_detectable_bias"), 0.0);
    EXPECT_EQ(test.at("equivalence").at("margin"), 0.5);
}

TEST(ResultsJson, ReadsBackAsTheSameDoubles) {
    const auto& expected = test::small_results().findings.cells.front().summaries;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(small().at("cells").at(0).at("summaries").at(i).at("mean").get<double>(), expected[i].mean);
    }
}

TEST(ResultsJson, HoldsThePublishedTablesAndClaims) {
    const json parsed = json::parse(results_json(test::published_results()));
    const json& published = parsed.at("published");
    EXPECT_EQ(published.at("source"), "A small publication");
    EXPECT_EQ(published.at("tables").at(0).at("figures").size(),
              10u);  // two columns of four pairs, and two sums of one
    EXPECT_EQ(published.at("claims").at(0).at("id"), "c");
}

TEST(ResultsJson, ComparesEveryPairOfMethodsExceptByMeasuredTime) {
    const auto& contests = test::small_results().contests;
    const auto timed = std::count_if(contests.begin(), contests.end(), [](const studies::Contest& contest) {
        return contest.equal == studies::Equal::processor_time;
    });
    ASSERT_EQ(small().at("contests").size(), contests.size() - static_cast<std::size_t>(timed));
    ASSERT_FALSE(small().at("contests").empty());
    for (const json& contest : small().at("contests")) {
        const json& entrants = contest.at("entrants");
        EXPECT_EQ(contest.at("ratios").size(), entrants.size() * (entrants.size() - 1) / 2);
        for (const json& ratio : contest.at("ratios")) {
            const double better = entrants.at(ratio.at("better").get<std::size_t>()).at("value");
            const double worse = entrants.at(ratio.at("worse").get<std::size_t>()).at("value");
            EXPECT_EQ(ratio.at("ratio").get<double>(), worse / better);
        }
    }
}

TEST(ResultsJson, SaysHowOftenClaimedErrorsHold) {
    const auto& expected = test::small_results().claimed_errors;
    ASSERT_FALSE(expected.empty());
    ASSERT_EQ(small().at("claimed_errors").size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const json& row = small().at("claimed_errors").at(i);
        EXPECT_EQ(row.at("held"), expected[i].held);
        EXPECT_EQ(row.at("finding") == "fails", expected[i].finding == studies::ClaimedErrorFinding::fails);
    }
}

TEST(ResultsJson, IsTheSameEveryTime) {
    EXPECT_EQ(results_json(test::small_results()), results_json(studies::evaluate(test::small_store())));
}

TEST(ContextJson, RecordsTheKnownCircumstancesOfTheRun) {
    const json parsed = json::parse(context_json({{"host", "h \"x\""}, {"threads", "2"}}));
    EXPECT_EQ(parsed.at("host"), "h \"x\"");
    EXPECT_EQ(parsed.size(), 2u);
}

}  // namespace
}  // namespace ff::reports
