#include "studies/audit/audit.hpp"

#include "tests/unit/studies/audit/simulated_tables.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace ff::studies::audit {
namespace {

using testing::HasSubstr;

/// The audit of the paper's tables, made once.
struct Paper {
    PublishedTables tables = read_published_tables(test::paper_tables_file());
    Report report = examine(tables);
};
const Paper& paper() {
    static const Paper once;
    return once;
}

const Finding* find(const Report& report, const std::string& id) {
    const auto found =
        std::find_if(report.findings.begin(), report.findings.end(), [&](const Finding& f) { return f.id == id; });
    return found == report.findings.end() ? nullptr : &*found;
}

/// The correction of the first figure in the finding `id`.
std::string meant(const std::string& id) {
    const Finding* finding = find(paper().report, id);
    return finding == nullptr || finding->corrections.empty() ? "not found" : finding->corrections.front().meant;
}

// The expected corrections follow by hand from the printed figures: see the arithmetic beside each.

TEST(AuditOfThePaper, FindsAtLeastSevenContradictions) {
    EXPECT_GE(paper().report.contradictions(), 7u);
}

TEST(AuditOfThePaper, RestoresTheDroppedDigitOfARowSum) {
    // 0.200634 + 0.199025 + 0.200161 + 0.198305 + 0.199138 = 0.997263
    EXPECT_EQ(meant("table4.3.2"), "0.997264");
}

TEST(AuditOfThePaper, FindsAWrongSumOfErrors) {
    // 100 * (0.002667 + 0.00114 + 0.001944 + 0.00367 + 0.00464) = 1.4061
    EXPECT_EQ(meant("table2.7.1"), "1.41");
}

TEST(AuditOfThePaper, RecoversARowCopiedFromAnother) {
    // 1 - 0.200502 - 0.200634 - 0.199044 - 0.200625 = 0.199195, and 100 * (0.1998 - 0.199195) / 0.1998 = 0.303
    const Finding* finding = find(paper().report, "table5.1.3+1");
    ASSERT_NE(finding, nullptr);
    ASSERT_EQ(finding->corrections.size(), 2u);
    EXPECT_EQ(finding->corrections[0].meant, "0.199195");
    EXPECT_EQ(finding->corrections[1].meant, "0.30");
    EXPECT_TRUE(finding->corrections[0].certain);
    EXPECT_EQ(finding->corrections[0].hits->low, 21040);
}

TEST(AuditOfThePaper, RecoversAPairFromTwoRows) {
    // 1.00016 - 0.200502 - 0.198892 - 0.201051 - 0.200691 = 0.199024; 0.199025 * 105625 = 21022.0
    EXPECT_EQ(meant("table5.2.3+1"), "0.199025");
    EXPECT_FALSE(find(paper().report, "table5.2.3+1")->alternatives.empty());
}

TEST(AuditOfThePaper, FindsTheReferenceThatWasActuallyUsed) {
    const Finding* finding = find(paper().report, "reference: table5 parallel");
    ASSERT_NE(finding, nullptr);
    EXPECT_THAT(finding->statement, HasSubstr("relative to 0.1998, not to the stated 0.199824"));
}

TEST(AuditOfThePaper, FindsTwoTruncatedErrors) {
    // 100 * (0.201615 - 0.200043) / 0.200043 = 0.7858, 100 * (0.200043 - 0.198305) / 0.200043 = 0.8688
    EXPECT_EQ(meant("table6.1.2+11"), "0.79");
    EXPECT_EQ(meant("table6.9.4"), "0.87");
}

TEST(AuditOfThePaper, DetectsLostRays) {
    const auto found = std::find_if(paper().report.findings.begin(), paper().report.findings.end(),
                                    [](const Finding& f) { return f.relation == Relation::closure; });
    ASSERT_NE(found, paper().report.findings.end());
    EXPECT_THAT(found->statement, HasSubstr("50 to 58 of 9000000 rays were lost"));
}

TEST(AuditOfThePaper, ShowsThatFiguresAreRoundedNotTruncated) {
    EXPECT_NE(find(paper().report, "printing rule: SR"), nullptr);
    for (const InferredFormat& f : paper().report.formats) {
        if (f.method != "SR") continue;
        EXPECT_EQ(f.format, (NumberFormat{Rounding::rounded, Layout::significant_digits, 6}));
    }
}

TEST(AuditOfThePaper, RefutesTheReadingOfTable3InTheText) {
    int possible = 0;
    for (const ReadingEvidence& r : paper().report.readings) {
        if (!r.refuted) ++possible;
        EXPECT_TRUE(r.stated_in != "text" || r.refuted);
        EXPECT_TRUE(r.stated_in != "columns" || !r.refuted);
    }
    EXPECT_EQ(possible, 1);
}

TEST(AuditOfThePaper, RecoversEveryHitCountOfTables4To6) {
    int recovered = 0;
    for (const RecoveredHits& h : paper().report.hits) {
        if (h.rays != 105625) continue;
        ASSERT_TRUE(h.consistent) << describe(paper().tables, h.figure);
        EXPECT_EQ(h.consistent->count(), 1) << describe(paper().tables, h.figure);
        ++recovered;
    }
    EXPECT_EQ(recovered, 6 + 3 + 12);
}

TEST(AuditOfThePaper, IsRepeatable) {
    const Report again = examine(paper().tables);
    ASSERT_EQ(again.findings.size(), paper().report.findings.size());
    for (std::size_t k = 0; k < again.findings.size(); ++k) {
        EXPECT_EQ(again.findings[k].id, paper().report.findings[k].id);
        EXPECT_EQ(again.findings[k].statement, paper().report.findings[k].statement);
        EXPECT_EQ(again.findings[k].alternatives, paper().report.findings[k].alternatives);
    }
}

TEST(Audit, ChecksStatedReferencesAgainstExactValues) {
    PublishedTables tables = test::simulate_tables(1);
    tables.reference_parallel = "0.199852";  // digits swapped
    const Report report = examine(tables);
    EXPECT_NE(find(report, "stated reference: parallel"), nullptr);
}

TEST(Audit, AcceptsTablesWithoutFigures) {
    PublishedTables tables;
    tables.scene.name = "cube";
    EXPECT_EQ(examine(tables).contradictions(), 0u);
}

TEST(Audit, FindsDigitsThatTheFormatCannotPrint) {
    PublishedTables tables = test::simulate_tables(1);
    const auto sum = std::find_if(tables.figures.begin(), tables.figures.end(), [](const Figure& f) {
        return f.method == "MC" && f.kind == FigureKind::row_sum && f.printed.starts_with("1.0");
    });
    ASSERT_NE(sum, tables.figures.end());
    sum->printed = "1.0012345";
    const auto index = static_cast<std::size_t>(sum - tables.figures.begin());
    const Report report = examine(tables);
    ASSERT_EQ(report.contradictions(), 1u);
    EXPECT_EQ(report.findings.front().relation, Relation::printing);
    EXPECT_EQ(report.findings.front().blamed.front(), index);
}

}  // namespace
}  // namespace ff::studies::audit
