#include "reports/markdown/markdown.hpp"

#include "reports/text/labels.hpp"
#include "tests/support/studies.hpp"
#include "tests/unit/reports/small_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <regex>

namespace ff::reports {
namespace {

using testing::HasSubstr;
using testing::Not;

std::ptrdiff_t bars(const std::string& line) {
    std::ptrdiff_t count = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '|' && (i == 0 || line[i - 1] != '\\')) ++count;
    }
    return count;
}

/// Tables whose rows do not all have as many cells as their header, by their first line.
std::vector<std::string> unbalanced_tables(const std::string& text) {
    std::vector<std::string> unbalanced;
    const auto lines = test::lines_of(text);
    std::string header;
    for (const std::string& line : lines) {
        if (line.empty() || line.front() != '|') {
            header.clear();
            continue;
        }
        if (header.empty()) header = line;
        if (bars(line) != bars(header) || line.back() != '|') unbalanced.push_back(header);
    }
    return unbalanced;
}

TEST(UnbalancedTables, AreFound) {
    EXPECT_TRUE(unbalanced_tables("| a | b |\n|---|---|\n| 1 | 2 |\n\n| c |\n").empty());
    EXPECT_EQ(unbalanced_tables("| a | b |\n|---|---|\n| 1 |\n").size(), 1u);
    EXPECT_EQ(unbalanced_tables("| a | b |\n|---|---|\n| 1 | x|y |\n").size(), 1u);
    EXPECT_EQ(unbalanced_tables("| a | b |\n|---|---|\n| 1 | x |oops\n").size(), 1u);
}

TEST(MarkdownReport, HasTablesOfEqualRows) {
    for (const auto* results : {&test::small_results(), &test::published_results()}) {
        const std::string text = markdown_report(*results);
        EXPECT_THAT(unbalanced_tables(text), testing::IsEmpty());
        EXPECT_GT(std::count(text.begin(), text.end(), '|'), 100);
    }
}

TEST(MarkdownReport, HasNoNanOrInfinity) {
    for (const auto* results : {&test::small_results(), &test::published_results()}) {
        const std::string text = markdown_report(*results);
        EXPECT_FALSE(std::regex_search(text, std::regex("\\b(nan|inf)\\b"))) << text;
    }
}

TEST(MarkdownReport, NamesEveryMethodAndSize) {
    const std::string text = markdown_report(test::small_results());
    const auto& plan = test::small_results().findings.plan;
    for (const studies::Cell& cell : plan.cells) EXPECT_THAT(text, HasSubstr(cell_label(plan, cell)));
}

TEST(MarkdownReport, SaysWhyThereIsNoTest) {
    const std::string text = markdown_report(test::small_results());
    EXPECT_THAT(text, HasSubstr("infinite variance"));
    EXPECT_THAT(text, HasSubstr("deterministic"));
}

TEST(MarkdownReport, HoldsTheStudyThatMadeIt) {
    EXPECT_THAT(markdown_report(test::small_results()),
                HasSubstr(studies::to_toml(test::small_results().findings.plan.spec)));
}

TEST(MarkdownReport, NamesTheProgramAndNothingElseThatDiffersBetweenRuns) {
    studies::StudyResults results = test::small_results();
    results.context = {{"version", "1.2"}, {"revision", "abc"}};
    const std::string one = markdown_report(results);
    EXPECT_THAT(one, HasSubstr("Made by ffstudy 1.2, revision abc."));
    results.context.insert({{"host", "somewhere"}, {"seconds", "3"}, {"command", "ffstudy run a.toml"}});
    EXPECT_EQ(markdown_report(results), one);
}

TEST(MarkdownReport, ShowsPrintedFiguresBesideOurs) {
    const std::string text = markdown_report(test::published_results());
    EXPECT_THAT(text, HasSubstr("table1: Pairs"));
    EXPECT_THAT(text, HasSubstr("0.900000"));
    EXPECT_THAT(text, HasSubstr("PDM is better."));
}

TEST(MarkdownReport, WritesDittoMarksForFiguresOfTheRowAbove) {
    const std::string text = markdown_report(test::published_results());
    EXPECT_THAT(text, HasSubstr("| 4 - 5 | ″ | ″ | ″ | 0.200000"));
}

TEST(MarkdownReport, ShowsTheWorstPairOfEveryCell) {
    const std::string text = markdown_report(test::small_results());
    const auto& findings = test::small_results().findings;
    for (const studies::CellAnalysis& found : findings.cells) {
        if (!found.bias || found.bias->largest_t == 0) continue;
        const studies::Cell& cell = findings.plan.cells[found.cell];
        const std::string row = fmt::format("| {} | {} |", cell_label(findings.plan, cell),
                                            quantity_label(findings.plan.scenes[cell.scene], found.bias->largest_pair));
        EXPECT_THAT(text, HasSubstr(row));
    }
}

TEST(MarkdownReport, FoldsLongTables) {
    std::string methods;
    for (int i = 0; i < 41; ++i) {
        methods += fmt::format("[[method]]\nname = \"m{}\"\nsampler = \"random\"\nestimator = \"ray_shooting\"\n", i);
        methods += "samples_per_patch = 16\n";
    }
    const auto text =
        markdown_report(studies::evaluate(test::run(test::plan_of(test::study_text("trials = 2", methods)))));
    EXPECT_THAT(text, HasSubstr("<details><summary>41 rows</summary>\n\n| method and size |"));
    EXPECT_THAT(markdown_report(test::small_results()), Not(HasSubstr("rows</summary>")));
}

TEST(MarkdownReport, NumbersTheContradictions) {
    const auto& results = test::published_results();
    ASSERT_GE(results.published->audit.findings.size(), 2u);
    const std::string text = markdown_report(results);
    EXPECT_THAT(text, HasSubstr("\n1. "));
    EXPECT_THAT(text, HasSubstr("\n2. "));
}

TEST(MarkdownReport, SaysThatItIsPartial) {
    const studies::Store store = studies::Store::create_or_resume(test::in_memory, test::small_results().findings.plan);
    const std::string text = markdown_report(studies::evaluate(store));
    EXPECT_THAT(text, HasSubstr("Partial result"));
    EXPECT_THAT(unbalanced_tables(text), testing::IsEmpty());
    EXPECT_THAT(markdown_report(test::small_results()), testing::Not(HasSubstr("Partial result")));
}

TEST(MarkdownReport, IsTheSameForTheSameStore) {
    EXPECT_EQ(markdown_report(test::small_results()), markdown_report(studies::evaluate(test::small_store())));
}

}  // namespace
}  // namespace ff::reports
