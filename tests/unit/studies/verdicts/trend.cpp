#include "studies/verdicts/trend.hpp"

#include "core/support/error.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace ff::studies {
namespace {

using testing::HasSubstr;

/// Runs of 100 trials each; from `change` on the mean is larger by `shift` standard errors, and all cost half.
History history_of(std::size_t runs, std::size_t change, double shift) {
    std::mt19937_64 engine(1);
    std::normal_distribution<double> normal;
    History history;
    for (std::size_t run = 0; run < runs; ++run)
        history.push_back({.commit = fmt::format("c{}", run),
                           .quantity = "flux",
                           .mean = 1 + 0.01 * (normal(engine) + (run >= change ? shift : 0)),
                           .standard_error = 0.01 * (1 + 0.05 * normal(engine)),
                           .n = 100,
                           .cost = (run >= change ? 5 : 10) * (1 + 0.01 * normal(engine))});
    return history;
}

const Trend& trend_of(const std::vector<Trend>& trends, TrendOf what) {
    return *std::find_if(trends.begin(), trends.end(), [&](const Trend& trend) { return trend.what == what; });
}

TEST(FindTrends, TellsWhatChangedAndWhen) {
    const auto trends = find_trends(history_of(40, 30, 6), {});
    ASSERT_EQ(trends.size(), 3u);
    const Trend& mean = trend_of(trends, TrendOf::mean);
    EXPECT_TRUE(mean.changed);
    EXPECT_EQ(mean.commits[mean.change->first], "c30");
    EXPECT_FALSE(trend_of(trends, TrendOf::spread).changed);
    const Trend& cost = trend_of(trends, TrendOf::cost);
    EXPECT_TRUE(cost.changed);
    EXPECT_NEAR(cost.change->before, 10, 0.1);
    EXPECT_NEAR(cost.change->after, 5, 0.05);
    for (const Trend& trend : find_trends(history_of(40, 40, 0), {})) EXPECT_FALSE(trend.changed) << name(trend.what);
}

TEST(FindTrends, DoesNotTestWhatCannotBeTested) {
    for (const Trend& trend : find_trends(history_of(6, 3, 9), {})) EXPECT_THAT(trend.note, HasSubstr("too few"));
    auto history = history_of(40, 30, 6);
    history.back().n = 400;
    for (const Trend& trend : find_trends(history, {})) EXPECT_THAT(trend.note, HasSubstr("n differs"));
}

TEST(History, IsReadAsItWasWritten) {
    auto history = history_of(3, 3, 0);
    history[1].cost.reset();
    history[2].n = 0;
    const auto read = parse_history(history_csv(history), "h.csv");
    ASSERT_EQ(read.size(), 3u);
    EXPECT_EQ(read[0].mean, history[0].mean);
    EXPECT_EQ(read[0].cost, history[0].cost);
    EXPECT_FALSE(read[1].cost);
    EXPECT_FALSE(read[2].spread());
    EXPECT_TRUE(has_commit(read, "c2"));
    EXPECT_FALSE(has_commit(read, "c3"));
}

TEST(History, RefusesFilesThatAreNotHistories) {
    EXPECT_THROW(parse_history("a,b\n1,2\n", "h.csv"), UserError);
    EXPECT_THROW(parse_history("commit,quantity,mean,standard_error,n,cost\nc,x,nan,1,1,1\n", "h.csv"), UserError);
    EXPECT_THROW(parse_history("commit,quantity,mean,standard_error,n,cost\nc,x,1,-1,1,1\n", "h.csv"), UserError);
}

TEST(History, KeepsSingleValuesAndNamesArrays) {
    const auto file =
        parse_reported("quantity,bin,mean,standard_error,n\nflux,0,1,0.1,9\nflux,1,2,0.1,9\nleak,0,3,0.1,16\n", "f.csv",
                       Errors::required);
    std::vector<std::string> left_out;
    const auto rows = summarise(file, "c", left_out);
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].quantity, "leak");
    EXPECT_EQ(*rows[0].spread(), 0.4);
    EXPECT_EQ(left_out, std::vector<std::string>{"flux"});
}

}  // namespace
}  // namespace ff::studies
