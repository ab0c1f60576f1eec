#include "reports/terminal/terminal.hpp"

#include "reports/text/labels.hpp"
#include "tests/unit/reports/small_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ff::reports {
namespace {

using testing::HasSubstr;

TEST(TerminalSummary, HasALineForEveryCell) {
    const auto& results = test::small_results();
    const std::string text = terminal_summary(results);
    for (const studies::Cell& cell : results.findings.plan.cells) {
        EXPECT_THAT(text, HasSubstr(size_label(results.findings.plan, cell)));
        EXPECT_THAT(text, HasSubstr(results.findings.plan.spec.methods[cell.method].name));
    }
    EXPECT_THAT(text, testing::Not(HasSubstr("LOST")));
}

TEST(TerminalSummary, ColoursStatementsLikeTheReport) {
    studies::StudyResults results = test::small_results();
    for (studies::CellAnalysis& found : results.findings.cells) {
        if (!found.bias) continue;
        found.bias_finding = studies::BiasFinding::no_bias_found;
        found.equivalence = studies::EquivalenceFinding::inconclusive;
        found.bias->untestable = 0;
    }
    const std::string text = terminal_summary(results, {Colour::ansi});
    EXPECT_THAT(text, HasSubstr("\033[32mnone found"));
    EXPECT_THAT(text, HasSubstr("\033[33mnot shown"));
}

TEST(TerminalSummary, HighlightsALostRay) {
    studies::StudyResults results = test::small_results();
    results.findings.cells[0].lost_rays = 1;
    EXPECT_THAT(terminal_summary(results), HasSubstr("1 rays LOST"));
}

TEST(TerminalSummary, SaysThatItIsPartial) {
    studies::StudyResults results = test::small_results();
    results.findings.complete = false;
    EXPECT_THAT(terminal_summary(results), HasSubstr("PARTIAL"));
}

TEST(TerminalPlan, StatesWorkAndTime) {
    const auto& plan = test::small_results().findings.plan;
    const std::string one = terminal_plan(plan, 1);
    EXPECT_THAT(one, HasSubstr("work units"));
    EXPECT_THAT(one, HasSubstr("on 1 thread\n"));
    EXPECT_THAT(terminal_plan(plan, 2), HasSubstr("on 2 threads"));
}

}  // namespace
}  // namespace ff::reports
