#include "studies/trials/until.hpp"

#include "core/support/error.hpp"
#include "studies/analysis/analysis.hpp"
#include "studies/run/run.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <atomic>
#include <string>

namespace ff::studies {
namespace {

using test::study_text;
using testing::HasSubstr;

std::string adaptive(std::string_view rule, std::uint64_t trials, std::string_view method = R"(sampler = "sobol"
estimator = "ray_shooting"
samples_per_patch = [64, 256])") {
    return study_text(fmt::format("trials = {}", trials),
                      fmt::format("[[method]]\nname = \"a\"\n{}\n[until]\n{}\n", method, rule));
}

std::string refusal(std::string_view text) {
    try {
        static_cast<void>(test::plan_of(text));
    } catch (const UserError& error) {
        return error.what();
    }
    return {};
}

TEST(StoppingRule, IsReadAndWrittenBack) {
    const StudySpec spec = parse_study(adaptive("ci = 0.01\npilot = 12", 50), "study.toml");
    EXPECT_EQ(spec.until, (StoppingRule{StoppingGoal::ci, 0.01, 12}));
    EXPECT_EQ(parse_study(to_toml(spec), "again"), spec);
    EXPECT_EQ(parse_stopping_rule("rmse=2e-5"), (StoppingRule{StoppingGoal::rmse, 2e-5, 30}));
}

TEST(StoppingRule, IsRefusedWithTheReason) {
    EXPECT_THAT(refusal(adaptive("pilot = 12", 50)), HasSubstr("expected one goal"));
    EXPECT_THAT(refusal(adaptive("ci = 1\nrmse = 1", 50)), HasSubstr("expected one goal"));
    EXPECT_THAT(refusal(adaptive("ci = 0", 50)), HasSubstr("no number of trials reaches 0"));
    EXPECT_THAT(refusal(adaptive("ci = 0.1\npilot = 4", 50)), HasSubstr("5 to 50 trials"));
    EXPECT_THAT(refusal(adaptive("ci = 0.1", 20)), HasSubstr("5 to 20 trials"));
    EXPECT_THAT(refusal(adaptive("ci = 0.1\nplot = 9", 50)), HasSubstr("Did you mean 'pilot'?"));
    for (const std::string_view text : {"rmse", "rmse=", "rmse=0", "rmse=-1", "rmse=nan", "rmse=1e-5x", "width=1"})
        EXPECT_THROW(static_cast<void>(parse_stopping_rule(text)), UserError) << text;
}

TEST(Until, RunsThePilotAndThenTheTrialsItsSpreadRequires) {
    const StudyPlan plan = test::plan_of(adaptive("ci = 0.008\npilot = 10", 5000));
    const Store store = test::run(plan);
    const auto outcomes = until_outcomes(store);
    ASSERT_EQ(outcomes.size(), 2u);
    for (const UntilOutcome& outcome : outcomes) {
        EXPECT_EQ(outcome.finding, UntilFinding::reached);
        EXPECT_LE(*outcome.achieved, 0.008);
        EXPECT_GE(outcome.trials, outcome.wanted);
        EXPECT_LT(outcome.trials, plan.spec.trials);
        EXPECT_EQ(outcome.trials, needed_trials(store, outcome.cell));
    }
    EXPECT_GT(outcomes.front().trials, outcomes.back().trials);  // 64 rays need more trials than 256
    EXPECT_TRUE(all_reached(outcomes));

    const Analysis findings = analyse(store);
    EXPECT_TRUE(findings.complete);
    for (const CellAnalysis& found : findings.cells) {
        const auto& interval = found.summary({QuantityKind::form_factor, 1, 6}).bias_interval;
        EXPECT_EQ(interval->method, "stein_two_stage");
        EXPECT_LE(interval->width() / 2, 0.008);
    }
}

TEST(Until, SaysWhyItWasNotReached) {
    const auto too_many = until_outcomes(test::run(test::plan_of(adaptive("rmse = 1e-6\npilot = 5", 20))));
    EXPECT_EQ(too_many.front().finding, UntilFinding::too_many_trials);
    EXPECT_EQ(too_many.front().trials, 20u);
    EXPECT_GT(too_many.front().wanted, 20u);
    EXPECT_FALSE(all_reached(too_many));

    const auto infinite =
        until_outcomes(test::run(test::plan_of(adaptive("rmse = 0.01\npilot = 5", 20, R"(sampler = "random"
estimator = "area_kernel"
samples_per_patch = 64)"))));
    EXPECT_EQ(infinite.front().finding, UntilFinding::infinite_variance);
    EXPECT_EQ(infinite.front().unjudged, 24u);

    const auto few = until_outcomes(test::run(test::plan_of(adaptive("rmse = 0.01\npilot = 5", 20, R"(sampler = "random"
estimator = "ray_shooting"
samples_per_patch = 8)"))));
    EXPECT_EQ(few.front().finding, UntilFinding::too_few_hits);
}

// Every trial is a function of its number alone, so an interruption anywhere, and any number of threads, must change
// neither the decision nor a value.
TEST(Until, DecidesTheSameAfterAnInterruptionAndForAnyThreads) {
    const test::TemporaryFolder folder;
    const StudyPlan plan = test::plan_of(adaptive("ci = 0.01\npilot = 10", 5000));
    test::run(plan, folder.path() / "whole.sqlite", 2);
    {
        Store store = Store::create_or_resume(folder.path() / "parts.sqlite", plan);
        std::atomic<bool> stop{false};
        RunOptions options;
        options.stop = &stop;
        options.report = [&](const RunProgress& progress) { stop = progress.units_done >= 1; };
        EXPECT_EQ(run_study(store, options), RunOutcome::stopped);
        EXPECT_FALSE(analyse(store).complete);
    }
    test::run(plan, folder.path() / "parts.sqlite", 1);
    EXPECT_EQ(test::rows_of(folder.path() / "whole.sqlite"), test::rows_of(folder.path() / "parts.sqlite"));
}

TEST(Until, LeavesDeterministicMethodsAlone) {
    const Store store = test::run(test::plan_of(adaptive("ci = 0.01", 50, R"(sampler = "gauss_legendre"
nodes = 2
estimator = "area_kernel")")));
    EXPECT_TRUE(until_outcomes(store).empty());
    EXPECT_TRUE(analyse(store).complete);
}

}  // namespace
}  // namespace ff::studies
