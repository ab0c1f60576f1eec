#include "reports/csv/gates_csv.hpp"
#include "reports/html/gates_html.hpp"
#include "reports/json/gates_json.hpp"
#include "reports/json/gates_junit.hpp"
#include "reports/markdown/gates_markdown.hpp"
#include "reports/terminal/gates_terminal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include <limits>
#include <sstream>

namespace ff::reports {
namespace {

using studies::gates::Verdict;
using testing::HasSubstr;
using testing::Not;

studies::gates::Measurement measured(double value) {
    studies::gates::Measurement measurement;
    measurement.value = value;
    measurement.passing = {.low = value - 0.25, .high = value + 0.25, .level = 0.9, .method = "student_t", .n = 8};
    measurement.failing = {.low = value - 0.5, .high = value + 0.5, .level = 0.99, .method = "student_t", .n = 8};
    measurement.minimum_detectable = 2.5;
    return measurement;
}

/// Two of three gates are done: one passed, with a name that every format has to escape; one failed.
studies::gates::CheckResults two_of_three() {
    studies::gates::CheckResults check;
    check.spec.name = "push";
    for (const char* name : {"a \"quoted\", <tagged> & named", "wrong", "waiting"})
        check.spec.gates.emplace_back().name = name;
    studies::gates::Comparison row;
    row.scene = "cube";
    row.method = "random ray_shooting";
    row.patches_per_face = 4;
    row.samples_per_patch = 64;
    row.from_face = "1";
    row.to_face = "6";
    row.quantity = "bias";
    row.band = {-1, 1};
    row.measurement = measured(0.5);
    row.verdict = Verdict::pass;
    row.levels = {.fail_alpha = 0.01, .pass_alpha = 0.05, .power = 0.9};
    row.trials = 8;
    studies::gates::GateResult passed{
        check.spec.gates[0].name, studies::gates::GateKind::bias, Verdict::pass, {row}, 1, 100, ""};
    row.to_face = "sum";
    row.patches_per_face.reset();
    row.band = {0.8, std::numeric_limits<double>::infinity()};
    row.measurement = measured(0.125);
    row.verdict = Verdict::fail;
    studies::gates::Comparison silent = row;
    silent.measurement.reset();
    silent.verdict = Verdict::inconclusive;
    silent.note = "too few";
    check.results = {passed,
                     {"wrong", studies::gates::GateKind::closure, Verdict::fail, {silent, row}, 2, 200, "a note"}};
    return check;
}

TEST(VerdictsCsv, HasARowForEachComparisonAndEmptyCellsForMissingValues) {
    std::ostringstream out;
    write_verdicts_csv(out, two_of_three());
    EXPECT_EQ(out.str(),
              "gate,scene,method,patches_per_face,samples_per_patch,from_face,to_face,quantity,value,ci_low,ci_high,"
              "band_low,band_high,verdict,minimum_detectable,alpha,power\n"
              "\"a \"\"quoted\"\", <tagged> & named\",cube,random ray_shooting,4,64,1,6,bias,0.5,0.25,0.75,-1,1,pass,"
              "2.5,0.01,0.9\n"
              "wrong,cube,random ray_shooting,,64,1,sum,bias,,,,0.8,,inconclusive,,0.01,0.9\n"
              "wrong,cube,random ray_shooting,,64,1,sum,bias,0.125,-0.125,0.375,0.8,,fail,2.5,0.01,0.9\n");
}

TEST(VerdictsJson, HoldsBothIntervalsAndSaysIfIncomplete) {
    const auto json = nlohmann::json::parse(verdicts_json(two_of_three()));
    EXPECT_EQ(json["complete"], false);
    EXPECT_EQ(json["verdict"], "fail");
    EXPECT_EQ(json["gates"].size(), 2u);
    const auto& rows = json["gates"][1]["comparisons"];
    EXPECT_TRUE(rows[0]["value"].is_null());
    EXPECT_EQ(rows[0]["note"], "too few");
    EXPECT_TRUE(rows[1]["band"]["high"].is_null());
    EXPECT_EQ(rows[1]["passing_interval"]["high"], 0.375);
    EXPECT_EQ(rows[1]["failing_interval"]["level"], 0.99);
}

TEST(Junit, ReportsUnfinishedGatesAsErrors) {
    pugi::xml_document document;
    const std::string text = junit_xml(two_of_three(), {"2026-11-20T16:30:00", "host", {1.5, 0.25}, {"", "slower"}});
    ASSERT_TRUE(document.load_string(text.c_str()));
    const auto suite = document.child("testsuites").child("testsuite");
    EXPECT_EQ(suite.attribute("tests").as_int(), 3);
    EXPECT_EQ(suite.attribute("failures").as_int(), 1);
    EXPECT_EQ(suite.attribute("errors").as_int(), 1);
    EXPECT_EQ(std::string(suite.attribute("time").value()), "1.750");
    const auto passed = suite.child("testcase");
    EXPECT_EQ(std::string(passed.attribute("name").value()), "a \"quoted\", <tagged> & named");
    EXPECT_FALSE(passed.child("failure") || passed.child("error"));
    const auto failed = passed.next_sibling();
    EXPECT_THAT(failed.child("failure").attribute("message").value(), HasSubstr("a note"));
    EXPECT_FALSE(failed.child("system-out"));
    EXPECT_THAT(suite.child("system-out").text().get(), HasSubstr("slower"));
    EXPECT_EQ(std::string(failed.next_sibling().child("error").attribute("type").value()), "not run");
}

TEST(Junit, FindsResultsByNameWhateverTheirOrder) {
    auto check = two_of_three();
    std::swap(check.results[0], check.results[1]);
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(junit_xml(check, {"2026-11-20T16:30:00", "host", {1.5, 0.25}, {"", ""}}).c_str()));
    const auto first = document.child("testsuites").child("testsuite").child("testcase");
    EXPECT_EQ(std::string(first.attribute("time").value()), "0.250");
    EXPECT_FALSE(first.child("failure"));
    EXPECT_TRUE(first.next_sibling().child("failure"));
}

TEST(GatesMarkdown, ShowsFailedGatesFirstAndEscapesNames) {
    const std::string text = gates_markdown(two_of_three());
    EXPECT_THAT(text, HasSubstr("### Gates of push: 1 passed, 1 failed, 0 inconclusive, 1 not run"));
    EXPECT_LT(text.find("| **fail** | wrong | closure |"), text.find("| pass | "));
    EXPECT_THAT(text, HasSubstr("a \"quoted\", \\<tagged> & named"));
}

TEST(GatesHtml, IsAPageWithAPictureForEachMeasuredGate) {
    const std::string text = gates_html(two_of_three());
    EXPECT_THAT(text, testing::StartsWith("<!doctype html>\n<html lang=\"en\">"));
    EXPECT_THAT(text, HasSubstr("a \"quoted\", &lt;tagged&gt; &amp; named"));
    EXPECT_THAT(text, HasSubstr("<td class=\"fail\">fail</td><td>wrong</td><td><svg"));
    EXPECT_THAT(text, Not(HasSubstr("<script")));
    EXPECT_THAT(text, Not(testing::ContainsRegex("nan|inf\"")));
}

TEST(GateLine, ShowsTheDecidingComparison) {
    const auto check = two_of_three();
    const std::string line = gate_line(check.results[1], Colour::none);
    EXPECT_THAT(line, HasSubstr("fail "));
    EXPECT_THAT(
        line,
        HasSubstr(
            "bias Σ1 0.125 (-0.125 to 0.375), band 0.8 or more; 2.5 would fail; 8 trials in 2 looks, worst of 2"));
    EXPECT_THAT(line, Not(HasSubstr("\033")));
    EXPECT_THAT(gate_line(check.results[1], Colour::ansi), HasSubstr("\033[31mfail"));
    EXPECT_THAT(gates_summary(check), HasSubstr("1 passed, 1 failed, 0 inconclusive, 1 not run."));
}

}  // namespace
}  // namespace ff::reports
