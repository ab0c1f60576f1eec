#include "reports/text/study_text.hpp"

#include "reports/html/html.hpp"
#include "reports/markdown/markdown.hpp"
#include "studies/scene_files/scene_file.hpp"
#include "tests/support/studies.hpp"
#include "tests/unit/reports/small_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

namespace ff::reports {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A file of so many lines, the last one with or without its end.
studies::SceneSource scene_of(int lines, const char* end = "\n") {
    std::string text;
    for (int line = 1; line <= lines; ++line) text += fmt::format("# line {}{}", line, line < lines ? "\n" : end);
    return studies::source_of_file("mesh.obj", text);
}

studies::StudySpec spec_of(const studies::SceneSource& scene) {
    studies::StudySpec spec = test::plan_of(test::study_text("trials = 2", test::random_rays)).spec;
    spec.scenes = {studies::scene_source("cube"), scene};
    return spec;
}

TEST(StudyText, IsTheStudyFileWhereNoSceneIsLong) {
    for (const studies::SceneSource& scene : {studies::scene_source("box:1x2x3"), scene_of(60), scene_of(60, "")}) {
        const StudyText shown = study_text(spec_of(scene));
        EXPECT_TRUE(shown.whole);
        EXPECT_EQ(shown.text, studies::to_toml(spec_of(scene)));
    }
}

TEST(StudyText, ShowsTheBeginningOfALongSceneAndSaysHowMuchFollows) {
    for (const char* end : {"\n", ""}) {
        const StudyText shown = study_text(spec_of(scene_of(1000, end)));
        EXPECT_FALSE(shown.whole);
        EXPECT_THAT(shown.text, HasSubstr("\"cube\", \"mesh.obj\\u000a# line 1\\u000a"));
        EXPECT_THAT(shown.text, HasSubstr("# line 20\\u000a… 980 more lines: results.sqlite has them\""));
        EXPECT_THAT(shown.text, Not(HasSubstr("# line 21")));
    }
}

TEST(StudyText, IsShortInReportsForPeople) {
    studies::StudyResults results = test::small_results();
    EXPECT_THAT(markdown_report(results), HasSubstr("The study, in full"));
    EXPECT_THAT(html_report(results, test::shipped_templates()), HasSubstr("The study below, saved as"));
    results.findings.plan.spec.scenes.push_back(scene_of(1000));
    for (const std::string& report : {markdown_report(results), html_report(results, test::shipped_templates())}) {
        EXPECT_THAT(report, HasSubstr("980 more lines"));
        EXPECT_THAT(report, Not(HasSubstr("# line 21")));
        EXPECT_THAT(report, Not(HasSubstr("The study, in full")));
        EXPECT_THAT(report, Not(HasSubstr("The study below, saved as")));
        EXPECT_THAT(report, HasSubstr("results.sqlite holds all of them"));
    }
}

}  // namespace
}  // namespace ff::reports
