#include "reports/words/findings/verdicts.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ff::reports {
namespace {

using studies::BiasFinding;
using studies::EquivalenceFinding;
using testing::HasSubstr;

studies::CellAnalysis sampled(BiasFinding finding, std::size_t untestable = 0) {
    studies::CellAnalysis found;
    found.trials = 100;
    found.trials_planned = 100;
    found.bias.emplace();
    found.bias->pairs = 30;
    found.bias->untestable = untestable;
    found.bias->minimum_detectable_bias = 1.25e-4;
    found.bias->largest_t = 7.3;
    found.bias->adjusted_p = 1e-9;
    found.bias->margin = 2e-4;
    found.bias->shown_below = 1.5e-4;
    found.bias_finding = finding;
    return found;
}

TEST(BiasInWords, StatesTheMinimumDetectableBiasWhereNoneIsFound) {
    EXPECT_EQ(bias_in_words(sampled(BiasFinding::no_bias_found)), "none found (0.00013)");
    EXPECT_THAT(bias_in_words(sampled(BiasFinding::no_bias_found, 24)), HasSubstr("on 6 of 30 pairs"));
}

TEST(BiasInWords, StatesScoreAndProbabilityOfABias) {
    EXPECT_THAT(bias_in_words(sampled(BiasFinding::biased)),
                testing::AllOf(HasSubstr("BIASED"), HasSubstr("t up to ±7.3"), HasSubstr("1e-09")));
}

TEST(BiasInWords, SaysWhyThereIsNoTest) {
    auto found = sampled(BiasFinding::untestable, 30);
    EXPECT_EQ(bias_in_words(found), "no test: no exact value");
    found.summaries.emplace_back().reference = 0.2;
    EXPECT_EQ(bias_in_words(found), "no test: no spread");
    found.bias->too_few_hits = 30;
    EXPECT_EQ(bias_in_words(found), "no test: too few hits");
    found.bias->infinite_variance = 24;
    EXPECT_EQ(bias_in_words(found), "no test: infinite variance or too few hits");
    found.repeated_trials = found.trials - 8;
    EXPECT_EQ(bias_in_words(found),
              fmt::format("no test: trials repeat each other ({} of {})", found.trials - 8, found.trials));
    studies::CellAnalysis deterministic;
    deterministic.trials = 1;
    EXPECT_THAT(bias_in_words(deterministic), HasSubstr("deterministic"));
    EXPECT_EQ(bias_in_words({}), "no trials yet");
}

TEST(Marks, AreSetForEachStatementIndependently) {
    const auto found = sampled(BiasFinding::no_bias_found);
    EXPECT_EQ(bias_mark(found), Mark::good);
    EXPECT_EQ(equivalence_mark(EquivalenceFinding::inconclusive), Mark::open);
    EXPECT_EQ(equivalence_mark(EquivalenceFinding::shown), Mark::good);
    EXPECT_EQ(equivalence_mark(EquivalenceFinding::refuted), Mark::bad);
    EXPECT_EQ(equivalence_mark(EquivalenceFinding::not_asked), Mark::none);
}

TEST(BiasInWords, SaysThatTrialsAreTooFew) {
    auto found = sampled(BiasFinding::untestable, 30);
    found.summaries.emplace_back().reference = 0.2;
    found.bias->few_trials = true;
    found.bias->infinite_variance = 24;
    EXPECT_EQ(bias_in_words(found), "no test: too few trials");
    EXPECT_EQ(bias_mark(found), Mark::open);
}

TEST(EquivalenceInWords, StatesTheMarginAndTheVerdict) {
    auto found = sampled(BiasFinding::no_bias_found);
    const auto words = [&](EquivalenceFinding finding) {
        found.equivalence = finding;
        return equivalence_in_words(found);
    };
    EXPECT_EQ(words(EquivalenceFinding::shown), "shown (±0.00015)");
    EXPECT_THAT(words(EquivalenceFinding::refuted), HasSubstr("refuted"));
    EXPECT_THAT(words(EquivalenceFinding::inconclusive), HasSubstr("not shown"));
    EXPECT_EQ(words(EquivalenceFinding::not_asked), "");
    found.bias->margin.reset();
    EXPECT_EQ(words(EquivalenceFinding::shown), "");
}

}  // namespace
}  // namespace ff::reports
