#include "reports/markdown/audit_markdown.hpp"
#include "reports/words/published_words.hpp"

#include "tests/unit/studies/audit/simulated_tables.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace ff::reports {
namespace {

using testing::HasSubstr;

TEST(AuditMarkdown, StartsWithTheVerdict) {
    const auto tables = studies::read_published_tables(test::paper_tables_file());
    const auto report = studies::audit::examine(tables);
    const std::string text = audit_markdown(tables, report);
    EXPECT_THAT(text, testing::StartsWith("# Audit of published tables\n"));
    EXPECT_THAT(text, HasSubstr("contain " + std::to_string(report.contradictions()) + " contradictions."));
    for (const studies::audit::Finding& finding : report.findings) EXPECT_THAT(text, HasSubstr(finding.statement));
    EXPECT_THAT(text, HasSubstr("## Recovered hits"));
    EXPECT_THAT(text, HasSubstr("| 21040 | 21040 |"));
}

TEST(AuditMarkdown, SaysSoWhereNothingIsWrong) {
    const auto tables = test::simulate_tables(4);
    const std::string text = audit_markdown(tables, studies::audit::examine(tables));
    EXPECT_THAT(text, HasSubstr("contain no contradiction."));
    EXPECT_THAT(text, testing::Not(HasSubstr("## Findings")));
}

TEST(AuditSummary, HasOneLinePerFinding) {
    const auto tables = studies::read_published_tables(test::paper_tables_file());
    const auto report = studies::audit::examine(tables);
    const std::string text = audit_summary(tables, report);
    EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')), 1 + report.findings.size());
}

}  // namespace
}  // namespace ff::reports
