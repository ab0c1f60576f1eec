// Sound tables of shot rays raise no alarm, in whichever of the usual ways they are printed.

#include "studies/audit/audit.hpp"
#include "tests/unit/studies/audit/rooms.hpp"
#include "tests/unit/studies/audit/sound_hits.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>
#include <vector>

namespace ff::studies::audit {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::vector<std::string> rooms{"cube", "box:50x60x8", "box:2x3x4", test::l_room};

const SceneFacts& room_facts(const std::string& scene) {
    static std::map<std::string, SceneFacts> known;
    const auto found = known.find(scene);
    if (found != known.end()) return found->second;
    PublishedTables tables = parse_published_tables(
        fmt::format(R"({{"source": "s", "scene": "{}", "methods": [], "tables": []}})", scene), "t.json");
    tables.figures.emplace_back();  // without figures no limits are computed
    return known.emplace(scene, scene_facts(tables)).first->second;
}

PublishedTables shot_in(const test::SoundHits& hits, std::mt19937_64& random) {
    return test::shoot_tables(hits, room_facts(hits.scene), random);
}

std::string in_brief(const test::SoundHits& hits) {
    return fmt::format("{} {} {} {} decimals, {} rays", hits.scene.substr(0, 12),
                       hits.reciprocal ? "reciprocal" : "direct", hits.truncated ? "truncated" : "rounded",
                       hits.decimals, hits.rays);
}

// The risk of one file is 1e-4, so 240 sound ones raise an alarm with probability 0.024 at most. A checker that does so
// in one file of 50 fails with probability 0.99.
TEST(AuditOfShotTables, RaisesNoAlarmWhereTheyAreSound) {
    std::mt19937_64 random(20);
    for (int k = 0; k < 240; ++k) {
        const test::SoundHits hits = test::any_hits(rooms, random);
        const Report report = examine(shot_in(hits, random));
        EXPECT_EQ(report.contradictions(), 0u)
            << k << " " << in_brief(hits) << ": " << report.findings.front().statement;
    }
}

// A digit of the first decimal is more than 30 standard deviations where a face shoots 10000 rays. Every such table is
// accused; with a true share of 0.99 that blame the planted figure first, fewer than 94 of 100 have a probability of
// 1e-4.
TEST(AuditOfShotTables, BlamesAFigureFarOutsideChance) {
    std::mt19937_64 random(21);
    int blamed = 0;
    for (int k = 0; k < 100; ++k) {
        test::SoundHits hits = test::any_hits(rooms, random);
        hits.rays = 10000;
        PublishedTables tables = shot_in(hits, random);
        std::size_t planted = random() % tables.figures.size();
        while (tables.figures[planted].kind != FigureKind::form_factor) planted = random() % tables.figures.size();
        char& digit = tables.figures[planted].printed[2];
        digit = static_cast<char>('0' + (digit - '0' + 1 + static_cast<int>(random() % 9)) % 10);
        const Report report = examine(tables);
        ASSERT_GE(report.contradictions(), 1u) << k << " " << in_brief(hits);
        const Finding& finding = report.findings.front();
        const bool right = report.contradictions() == 1 && !finding.blamed.empty() && finding.blamed.front() == planted;
        blamed += right ? 1 : 0;
        if (!right) fmt::print("{} {} {}: {}\n", k, in_brief(hits), describe(tables, planted), finding.statement);
    }
    RecordProperty("blamed", blamed);
    EXPECT_GE(blamed, 94);
}

PublishedTables figures_of_the_cube(const std::string& rule, int decimals, const std::vector<std::string>& rows,
                                    const std::string& completion = "direct") {
    std::string text;
    for (const std::string& row : rows) text += (text.empty() ? "" : ", ") + row;
    return parse_published_tables(
        fmt::format(
            R"({{"source": "s", "scene": "cube", "printing": {{"rule": "{}", "decimals": {}}},)"
            R"("methods": [{{"name": "m", "samples": true, "completion": "{}"}}], "tables": [{{"id": "t",)"
            R"("columns": [{{"method": "m", "patches_per_face": 1, "samples_per_patch": 250000}}], "rows": [{}]}}]}})",
            rule, decimals, completion, text),
        "t.json");
}

std::vector<std::string> row_of_face_1(const std::vector<std::string>& printed) {
    std::vector<std::string> rows;
    for (std::size_t j = 0; j < printed.size(); ++j)
        rows.push_back(fmt::format(R"({{"quantity": "F 1-{}", "printed": ["{}"]}})", j + 2, printed[j]));
    return rows;
}

// 0.19908 + 0.20036 + 0.19994 + 0.20062 + 0.19996 = 0.99996, which ten hits of 250000 make 1 if each figure has lost
// two at most. Rounded, they can only lose one each.
TEST(AuditOfShotTables, FindsTheFormatThatLeavesNoContradiction) {
    const auto rows = row_of_face_1({"0.19908", "0.20036", "0.19994", "0.20062", "0.19996"});
    for (const char* rule : {"truncated", "unstated"}) {
        const Report report = examine(figures_of_the_cube(rule, 5, rows));
        EXPECT_EQ(report.contradictions(), 0u) << rule;
        EXPECT_EQ(report.formats.front().format, (NumberFormat{Rounding::truncated, Layout::fixed_decimals, 5}))
            << rule;
    }
    const Report report = examine(figures_of_the_cube("rounded", 5, rows));
    ASSERT_EQ(report.contradictions(), 1u);
    EXPECT_NE(report.findings.front().relation, Relation::printing_rule);
}

std::vector<std::string> all_pairs(const std::string& printed) {
    std::vector<std::string> rows;
    for (int i = 1; i <= 6; ++i) {
        for (int j = 1; j <= 6; ++j) {
            if (i != j) rows.push_back(fmt::format(R"({{"quantity": "F {}-{}", "printed": ["{}"]}})", i, j, printed));
        }
    }
    return rows;
}

TEST(AuditOfShotTables, DoesNotFindRoundedValuesTooClose) {
    EXPECT_EQ(examine(figures_of_the_cube("rounded", 2, all_pairs("0.20"))).contradictions(), 0u);
    EXPECT_EQ(examine(figures_of_the_cube("rounded", 3, all_pairs("0.200"))).contradictions(), 0u);
    // Six digits of 250000 rays leave no room, and chance spreads them by 0.0008.
    const Report report = examine(figures_of_the_cube("rounded", 6, all_pairs("0.200000")));
    ASSERT_EQ(report.contradictions(), 1u);
    EXPECT_THAT(report.findings.front().statement, HasSubstr("too close"));
}

TEST(AuditOfShotTables, NamesLostRaysOnlyWhereASumExcludesOne) {
    std::vector<std::string> rows;
    for (int i = 1; i <= 6; ++i)
        rows.push_back(fmt::format(R"({{"quantity": "sum {}", "printed": ["{}"]}})", i, i < 4 ? "1.000" : "0.998"));
    const Report report = examine(figures_of_the_cube("rounded", 3, rows));
    ASSERT_GE(report.contradictions(), 1u);
    EXPECT_EQ(report.findings.front().relation, Relation::closure);
    EXPECT_THAT(report.findings.front().statement, HasSubstr("is 0.9975 to 0.9985"));
    EXPECT_THAT(report.findings.front().statement, Not(HasSubstr("1.000")));
}

}  // namespace
}  // namespace ff::studies::audit
