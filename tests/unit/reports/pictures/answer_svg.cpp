#include "reports/pictures/answer_svg.hpp"

#include "reports/text/labels.hpp"
#include "reports/words/answer.hpp"
#include "studies/comparison/decisions.hpp"
#include "tests/unit/reports/small_study.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <regex>
#include <string>

namespace ff::reports {
namespace {

using testing::HasSubstr;
using testing::Not;

std::ptrdiff_t count_of(const std::string& pattern, const std::string& text) {
    const std::regex regex(pattern);
    return std::distance(std::sregex_iterator(text.begin(), text.end(), regex), std::sregex_iterator());
}

TEST(AnswerSvg, DrawsTheLinesOfThePictureInTheHtmlReport) {
    const auto picture = answer_picture(test::published_results());
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->kind, "convergence");
    EXPECT_EQ(picture->id, lead_picture(test::published_results())->id);
    const auto values = nlohmann::json::parse(picture->values);
    std::ptrdiff_t printed = 0;
    std::ptrdiff_t measured = 0;
    for (const auto& row : values["rows"]) {
        printed += row[1] == "printed" ? 1 : 0;
        measured += row[1] == "RMSE" ? 1 : 0;
    }
    ASSERT_GT(printed, 0);
    const std::string svg = answer_svg(*picture);
    EXPECT_EQ(count_of("<circle[^>]*fill=\"none\"", svg), printed);
    EXPECT_EQ(count_of("<circle[^>]*fill=\"#", svg), measured);
    for (const auto& label : values["labels"])
        EXPECT_THAT(svg, HasSubstr(">" + label["text"].get<std::string>() + "<"));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    // Every mark lies within the drawing.
    const std::regex place("<circle cx=\"([-0-9.]+)\" cy=\"([-0-9.]+)\"");
    for (std::sregex_iterator each(svg.begin(), svg.end(), place); each != std::sregex_iterator(); ++each) {
        EXPECT_GE(std::stod((*each)[1]), 60);
        EXPECT_LE(std::stod((*each)[1]), 510);
        EXPECT_GE(std::stod((*each)[2]), 10);
        EXPECT_LE(std::stod((*each)[2]), 330);
    }
}

TEST(AnswerSvg, DrawsRankingsWhereTheReportHasNoLines) {
    const auto picture = answer_picture(test::small_results());
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->kind, "ranking");
    EXPECT_EQ(answer_svg(*picture), ranking_svg(*picture));
}

/// The picture and the sentence above it count evaluations alike: a ray serves all faces, a value of the kernel a pair.
TEST(AnswerSvg, ShowsTheCostThatTheAnswerNames) {
    const studies::StudyResults& results = test::published_results();
    const auto values = nlohmann::json::parse(answer_picture(results)->values);
    const studies::StudyPlan& plan = results.findings.plan;
    for (const auto& row : values["rows"]) {
        if (row[1] != "RMSE") continue;
        bool is_found = false;
        for (const studies::Cell& cell : plan.cells) {
            is_found = is_found || (plan.spec.methods[cell.method].name == row[0] &&
                                    6 * row[3].get<std::uint64_t>() == evaluations_per_trial(plan, cell));
        }
        EXPECT_TRUE(is_found) << row;
    }
}

/// Errors may be infinite where a program returns huge values: they have no place on an axis.
TEST(AnswerSvg, LeavesOutErrorsThatAreInfinite) {
    studies::StudyResults results = test::published_results();
    const auto marks = [&] { return count_of("<circle[^>]*fill=\"#", answer_svg(*answer_picture(results))); };
    const std::ptrdiff_t all = marks();
    const auto make_infinite = [](studies::CellAnalysis& cell) {
        for (studies::ClassError& error : cell.class_errors) {
            error.rmse = std::numeric_limits<double>::infinity();
            error.interval.reset();
        }
    };
    make_infinite(results.findings.cells.front());
    EXPECT_EQ(marks(), all - 1);
    std::ranges::for_each(results.findings.cells, make_infinite);
    const std::string svg = answer_svg(*publication_picture(results));
    EXPECT_THAT(svg, Not(testing::ContainsRegex("nan|inf[^i]")));
}

TEST(DecisionsSvg, NamesTheMethodsOfTheTableForEachTime) {
    studies::StudyResults results = test::small_results();
    std::erase_if(results.contests, [](const auto& each) { return each.equal != studies::Equal::evaluations; });
    const std::string without_times = decisions_svg(results).value();
    EXPECT_THAT(without_times, HasSubstr("There is no round processor time"));
    for (studies::Contest& contest : results.contests) {
        contest.equal = studies::Equal::processor_time;
        contest.budget = 0.01;
    }
    const std::string svg = decisions_svg(results).value();
    const auto times = studies::decide_by_time(results.findings.plan, results.contests);
    ASSERT_EQ(times.size(), 1u);
    EXPECT_THAT(svg, HasSubstr(">in 0.01 s<"));
    std::ptrdiff_t decided = 0;
    for (const studies::Decision& decision : times[0].decisions) {
        EXPECT_THAT(svg, HasSubstr(fmt::format(">{}<", kind_in_words(decision.kind))));
        const auto best = studies::most_often_best(decision);
        decided += best.empty() ? 0 : 1;
        if (best.size() == 1) {
            EXPECT_THAT(svg, HasSubstr(fmt::format(">{}<", results.findings.plan.spec.methods[best[0]].name)));
        }
    }
    EXPECT_GT(decided, 0);
    EXPECT_EQ(count_of("fill-opacity", svg), decided);
    EXPECT_FALSE(decisions_svg(test::published_results())) << "one scene";
}

}  // namespace
}  // namespace ff::reports
