#include "reports/html/html.hpp"

#include "core/support/error.hpp"
#include "reports/templates/mustache.hpp"
#include "reports/words/headline.hpp"
#include "tests/support/studies.hpp"
#include "tests/unit/reports/small_study.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <regex>

namespace ff::reports {
namespace {

using test::shipped_templates;
using testing::HasSubstr;
using testing::Not;

TEST(HtmlReport, HasAllTagsClosed) {
    const std::string text = html_report(test::published_results(), shipped_templates());
    for (const char* tag : {"table", "tr", "td", "th", "section", "details", "figure", "mark", "div", "script"}) {
        const std::regex open(std::string("<") + tag + "[ >]");
        const std::regex close(std::string("</") + tag + ">");
        const auto count = [&](const std::regex& pattern) {
            return std::distance(std::sregex_iterator(text.begin(), text.end(), pattern), std::sregex_iterator());
        };
        EXPECT_EQ(count(open), count(close)) << tag;
    }
}

TEST(HtmlReport, LoadsNoExternalResources) {
    const std::string text = html_report(test::published_results(), shipped_templates());
    EXPECT_FALSE(std::regex_search(text, std::regex("(src|href)=\"[^#]")));
    EXPECT_THAT(text, HasSubstr("default-src &#39;none&#39;"));
    EXPECT_THAT(text, Not(HasSubstr("unsafe")));
}

TEST(HtmlReport, HasNoNanOrInfinity) {
    const std::string& runtime = shipped_templates().text("vega.js");
    for (const auto* results : {&test::small_results(), &test::published_results()}) {
        std::string text = html_report(*results, shipped_templates());
        text.erase(text.find(runtime), runtime.size());
        // Outside of tags. A pattern for that would call itself once for each character, and use up the stack.
        const std::regex words("\\b(nan|inf)\\b");
        for (std::sregex_iterator word(text.begin(), text.end(), words); word != std::sregex_iterator(); ++word) {
            const auto at = static_cast<std::size_t>(word->position());
            EXPECT_EQ(text[text.find_last_of("<>", at)], '<') << text.substr(at - std::min<std::size_t>(at, 60), 80);
        }
    }
}

TEST(HtmlReport, EscapesNamesOfTheStudy) {
    EXPECT_THAT(html_report(test::small_results(), shipped_templates()), HasSubstr("SR &quot;quoted&quot;"));
}

TEST(HtmlReport, NamesTheProgramAndNothingElseThatDiffersBetweenRuns) {
    studies::StudyResults results = test::small_results();
    results.context = {{"version", "1.2"}, {"revision", "abc"}};
    const std::string one = html_report(results, shipped_templates());
    EXPECT_THAT(one, HasSubstr("Made by ffstudy 1.2, revision abc."));
    results.context.insert({{"host", "somewhere"}, {"seconds", "3"}, {"command", "ffstudy run a.toml"}});
    EXPECT_EQ(html_report(results, shipped_templates()), one);
}

/// What is measured of all built-in studies by scripts/docs.
TEST(HtmlReport, StaysBelowItsLimitForALargeStudy) {
    std::string methods;
    for (int i = 0; i < 30; ++i) {
        methods += fmt::format("[[method]]\nname = \"m{}\"\nsampler = \"random\"\nestimator = \"ray_shooting\"\n", i);
        methods += "samples_per_patch = [16, 32, 64, 128]\n";
    }
    const auto store = test::fill(test::plan_of(test::study_text("trials = 5", methods)),
                                  [](std::size_t cell, std::uint64_t trial, int from, int to) {
                                      const auto faces =
                                          5 * static_cast<std::size_t>(from) + 7 * static_cast<std::size_t>(to);
                                      return 0.125 + static_cast<double>((cell + 3 * trial + faces) % 4) / 16;
                                  });
    const std::string text = html_report(studies::evaluate(store), shipped_templates());
    EXPECT_LE(text.size(), 1'500'000u);
    EXPECT_THAT(text, HasSubstr("more methods and sizes are in summary.csv."));
}

TEST(HtmlReport, FoldsTheRowsOfALongTable) {
    std::string methods;
    for (int i = 0; i < 30; ++i)
        methods += fmt::format(
            "[[method]]\nname = \"m{}\"\nsampler = \"random\"\nestimator = \"ray_shooting\"\n"
            "samples_per_patch = 16\n",
            i);
    const auto results = studies::evaluate(test::run(test::plan_of(test::study_text("trials = 5", methods))));
    const std::string text = html_report(results, shipped_templates());
    EXPECT_THAT(text, HasSubstr("<summary>Methods and sizes: all 30 rows <small>30 rows: "));
    const auto folded = text.find("Methods and sizes: all 30 rows");
    const auto row = text.find("<th scope=\"row\">m12, ");
    EXPECT_GT(row, folded);
    EXPECT_LT(text.find("<th scope=\"row\">m11, "), folded);
}

TEST(HtmlReport, BeginsWithTheVerdict) {
    const Headline top = headline(test::published_results());
    const std::string text = html_report(test::published_results(), shipped_templates());
    EXPECT_THAT(top.verdict, HasSubstr("PDM"));
    EXPECT_THAT(top.verdict, HasSubstr("contradiction"));
    EXPECT_LT(text.find(escape_html(top.verdict)), text.find("<table"));
}

TEST(HtmlReport, MarksMisprints) {
    EXPECT_THAT(html_report(test::published_results(), shipped_templates()),
                testing::ContainsRegex("<mark class=\"misprint\">0.900000"));
}

TEST(HtmlReport, IsTheSameForTheSameStore) {
    EXPECT_EQ(html_report(test::small_results(), shipped_templates()),
              html_report(studies::evaluate(test::small_store()), shipped_templates()));
}

TEST(HtmlReport, SaysThatItIsPartial) {
    const studies::Store store = studies::Store::create_or_resume(test::in_memory, test::small_results().findings.plan);
    EXPECT_THAT(html_report(studies::evaluate(store), shipped_templates()), HasSubstr("Partial result"));
    EXPECT_THAT(html_report(test::small_results(), shipped_templates()), Not(HasSubstr("Partial result")));
}

TEST(Headline, BeginsWithTheAnswer) {
    const Headline top = headline(test::small_results());
    EXPECT_THAT(top.verdict, testing::StartsWith("Take PDM: "));
    EXPECT_GE(top.numbers.size(), 3u);
    EXPECT_TRUE(top.published.empty());
}

TEST(Templates, AreTakenFromTheLastFolderFirst) {
    const test::TemporaryFolder own;
    std::ofstream(own.path() / "report.css") << "own {}";
    const std::array<std::filesystem::path, 3> folders{FF_TEMPLATES, FF_PICTURES, own.path()};
    const Templates templates = Templates::read(folders);
    EXPECT_EQ(templates.text("report.css"), "own {}");
    EXPECT_NO_THROW((void)templates.text("report.mustache"));
    EXPECT_THROW((void)templates.text("nothing.css"), UserError);
}

TEST(Templates, AreRefusedFromAMissingFolder) {
    const std::array<std::filesystem::path, 1> folders{"/no/such/folder"};
    EXPECT_THROW(Templates::read(folders), IoError);
}

}  // namespace
}  // namespace ff::reports
