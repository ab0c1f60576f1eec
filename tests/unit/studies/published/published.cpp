#include "studies/published/published.hpp"

#include "core/support/error.hpp"
#include "tests/support/studies.hpp"
#include "tests/unit/studies/audit/simulated_tables.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace ff::studies {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

const std::string good = R"({
"source": "someone", "scene": "cube",
"printing": {"rule": "truncated", "decimals": 6},
"references": {"parallel": "0.199824"},
"methods": [{"name": "SR", "samples": true, "completion": "reciprocal"}],
"tables": [{"id": "t", "title": "A table",
  "columns": [{"title": "value", "method": "SR", "patches_per_face": 36, "samples_per_patch": 1000},
              {"method": "SR", "patches_per_face": 36, "samples_per_patch": 1000, "kind": "relative_error"}],
  "rows": [{"title": "one to six", "quantity": "F 1-6", "printed": ["0.199820", "0.00"]},
           {"quantity": "sum 2", "printed": ["1.0", null]}]}],
"readings": [{"table": "t", "statement": "in total", "rays_per_face": [10, 10]}],
"claims": [{"id": "c", "statement": "more is better", "kind": "error_falls_with_samples", "methods": ["SR"],
            "number": 2}]
})";

std::string replaced(const std::string& from, const std::string& to) {
    std::string text = good;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

std::string refusal_of_tables(const std::string& text) {
    return test::message_of<UserError>([&] { parse_published_tables(text, "t.json"); });
}

TEST(ParsePublishedTables, ReadsEveryPart) {
    const PublishedTables tables = parse_published_tables(good, "t.json");
    EXPECT_EQ(tables.rule, PrintingRule::truncated);
    EXPECT_EQ(tables.reference_parallel, "0.199824");
    EXPECT_FALSE(tables.reference_adjacent);
    EXPECT_THAT(tables.sampling_methods, testing::ElementsAre("SR"));
    EXPECT_THAT(tables.reciprocal_methods, testing::ElementsAre("SR"));
    ASSERT_EQ(tables.figures.size(), 3u);
    const Figure& value = tables.figures[0];
    EXPECT_EQ(value.kind, FigureKind::form_factor);
    EXPECT_EQ(value.printed, "0.199820");
    EXPECT_EQ(value.from, "1");
    EXPECT_EQ(value.to, "6");
    EXPECT_EQ(value.line, 9);
    EXPECT_EQ(tables.figures[1].kind, FigureKind::relative_error);
    EXPECT_EQ(tables.figures[2].kind, FigureKind::row_sum);
    ASSERT_EQ(tables.tables.size(), 1u);
    EXPECT_THAT(tables.tables[0].row_titles, testing::ElementsAre("one to six", "sum 2"));
    EXPECT_FALSE(tables.tables[0].figures[3]);
    EXPECT_EQ(tables.readings[0].rays_per_face[1], 10u);
    EXPECT_EQ(tables.claims[0].number, 2);
    EXPECT_EQ(describe(tables, 0), "t, one to six, value");
}

TEST(ParsePublishedTables, LeavesOutZerosOfFlatFaces) {
    const PublishedTables tables = parse_published_tables(
        replaced(R"("F 1-6", "printed": ["0.199820")", R"("F 6-6", "printed": ["0.000000")"), "t.json");
    EXPECT_FALSE(tables.tables[0].figures[0]);
}

TEST(ParsePublishedTables, SaysWhereAndWhatIsWrong) {
    const std::vector<std::pair<std::string, std::string>> cases{
        {replaced(R"("claims")", R"("claim")"), R"(Did you mean "claims"?)"},
        {replaced(R"("title": "one)", R"("titel": "one)"), R"(Did you mean "title"?)"},
        {replaced(R"("0.199820")", "0.199820"), "must be given as a string"},
        {replaced(R"("0.199820")", R"("0.19x820")"), "is not a printed number"},
        {replaced(R"(["1.0", null])", R"(["1.0"])"), "figures in the row: 1; columns of the table: 2"},
        {replaced(R"(["1.0", null])", R"(["1.0", "0.1"])"), "Write null here"},
        {replaced(R"("sum 2")", R"("total 2")"), "is not a quantity"},
        {replaced(R"("F 1-6")", R"("F 16")"), "is not a quantity"},
        {replaced(R"("F 1-6")", R"("F 1-7")"), R"(face "7" is not in the scene "cube" (its faces are 1, 2)"},
        {replaced(R"("sum 2")", R"("sum x")"), R"(face "x" is not in the scene)"},
        {replaced(R"("F 1-6")", R"("F 6-6")"), "to itself"},
        {replaced(R"("cube")", R"("kube")"), "Did you mean cube?"},
        {replaced(R"("truncated")", R"("trunkated")"), R"(Did you mean "truncated"?)"},
        {replaced(R"("method": "SR", "patches)", R"("method": "SB", "patches)"), "not among the file's"},
        {replaced(R"("samples_per_patch": 1000)", R"("samples_per_patch": 0)"), "whole number from 1"},
        {replaced(R"("patches_per_face": 36, "samples_per_patch": 1000)", R"("patches_per_face": 36)"),
         R"(has no "samples_per_patch")"},
        {replaced(R"("table": "t")", R"("table": "u")"), R"(no table "u")"},
        {replaced("[10, 10]", "[10]"), "has 1 entries but table"},
        {replaced(R"("scene": "cube",)", ""), R"(has no "scene")"},
        {replaced(R"("samples": true)", R"("samples": 1)"), "neither true nor false"},
    };
    for (const auto& [text, expected] : cases) {
        EXPECT_THAT(refusal_of_tables(text), AllOf(StartsWith("t.json:"), HasSubstr(expected)));
    }
}

TEST(ParsePublishedTables, PointsAtTheLine) {
    EXPECT_THAT(refusal_of_tables(replaced("\"sum 2\"", "\"total 2\"")), StartsWith("t.json:10:25: "));
}

const std::string two_plates = R"(s.obj\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n)"
                               R"(g low-\nf 1 2 3 4\ng high-er\nf 8 7 6 5)";

TEST(ParsePublishedTables, AcceptsAnyScene) {
    std::string text = replaced(R"("cube")", '"' + two_plates + '"');
    text.replace(text.find("F 1-6"), 5, "F low--high-er").replace(text.find("sum 2"), 5, "sum low-");
    const PublishedTables tables = parse_published_tables(text, "t.json");
    EXPECT_EQ(tables.scene.name, "s.obj");
    EXPECT_EQ(tables.figures[0].from, "low-");
    EXPECT_EQ(tables.figures[0].to, "high-er");
    EXPECT_THAT(refusal_of_tables(replaced(R"("cube")", R"("cube mirrors:6")")), HasSubstr("mirrors are not read"));
    EXPECT_THAT(refusal_of_tables(replaced(R"("cube")", R"("a.obj")")), HasSubstr("scene 'a.obj'"));
}

TEST(ReadPublishedTables, ReportsAMissingFile) {
    EXPECT_THROW(read_published_tables("/nowhere/tables.json"), IoError);
}

TEST(ParsePublishedTables, RefusesAnEmptyFile) {
    for (const char* text : {"", " \n"}) {
        EXPECT_THAT(refusal_of_tables(text), StartsWith("t.json: is empty"));
    }
}

TEST(ReadPublishedTables, ReadsThePapersTables) {
    const PublishedTables tables = read_published_tables(test::paper_tables_file());
    EXPECT_EQ(tables.tables.size(), 6u);
    EXPECT_EQ(tables.figures.size(), 7u * 3 + 7 * 3 + 7 * 2 + 7 * 2 + 3 * 4 + 12 * 4);
    EXPECT_GE(tables.claims.size(), 10u);
    for (const PublishedClaim& claim : tables.claims) EXPECT_FALSE(claim.kind.empty()) << claim.id;
}

}  // namespace
}  // namespace ff::studies
