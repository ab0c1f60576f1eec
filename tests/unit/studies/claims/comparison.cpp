#include "studies/claims/comparison.hpp"

#include "core/support/error.hpp"
#include "stats/basics/distributions.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>

namespace ff::studies {
namespace {

using test::plan_of;
using test::study_text;

constexpr std::string_view rays_and_pdm = R"([[method]]
name = "SR"
sampler = "random"
estimator = "ray_shooting"
completion = "reciprocal"
patches_per_face = 4
samples_per_patch = 256

[[method]]
name = "PDM"
sampler = "gauss_legendre"
estimator = "area_kernel"
nodes = 2
patches_per_face = 4
)";

const Store& store() {
    static const Store made = test::run(plan_of(study_text("trials = 200", rays_and_pdm)));
    return made;
}

const Analysis& findings() {
    static const Analysis made = analyse(store());
    return made;
}

/// A table with one column SR: F 1-2, F 1-3, sum 1, sum 2, the error of F 1-2, and the sum of errors.
PublishedTables table(std::string_view f12, std::string_view f13, std::string_view sum1, std::string_view sum2,
                      std::string_view sum_re, std::string_view method = "SR") {
    const std::string samples = method == "SR" ? R"(, "samples_per_patch": 256)" : "";
    return parse_published_tables(fmt::format(R"({{"source": "s", "scene": "cube",
          "methods": [{{"name": "{0}", "samples": {1}, "completion": "reciprocal"}}],
          "tables": [{{"id": "t", "title": "t",
            "columns": [{{"title": "c", "method": "{0}", "patches_per_face": 4{2}}}],
            "rows": [{{"title": "a", "quantity": "F 1-2", "printed": ["{3}"]}},
                     {{"title": "b", "quantity": "F 1-3", "printed": ["{4}"]}},
                     {{"title": "c", "quantity": "sum 1", "printed": ["{5}"]}},
                     {{"title": "d", "quantity": "sum 2", "printed": ["{6}"]}},
                     {{"title": "e", "quantity": "sum of relative errors", "printed": ["{7}"]}}]}}]}})",
                                              method, method == "SR", samples, f12, f13, sum1, sum2, sum_re),
                                  "t.json");
}

TableComparison compared(const PublishedTables& tables) {
    const auto list = compare_with_published(store(), findings(), tables);
    EXPECT_EQ(list.size(), 1u);
    return list.at(0);
}

/// The print of a single run: trial 0 of the store itself.
PublishedTables an_honest_run() {
    const CellEstimates estimates = load_estimates(store(), 0);
    const auto first = [&](Quantity q) { return fmt::format("{:.6f}", estimates.values(q)[0]); };
    return table(first({QuantityKind::form_factor, 1, 2}), first({QuantityKind::form_factor, 1, 3}), "1.0",
                 first({QuantityKind::row_sum, 2, 0}), first({QuantityKind::sum_relative_error, 0, 0}));
}

TEST(Comparison, FindsNothingUnusualInAnHonestRun) {
    const TableComparison table = compared(an_honest_run());
    ASSERT_EQ(table.figures.size(), 5u);
    for (const FigureComparison& c : table.figures) {
        EXPECT_EQ(c.cell, 0u);
        EXPECT_FALSE(c.deterministic);
        EXPECT_GT(c.adjusted_p.value(), 1e-3);
    }
    EXPECT_LT(std::abs(table.figures[0].z.value()), 4);
    ASSERT_EQ(table.chi_squared.size(), 1u);
    EXPECT_GT(table.chi_squared[0].form.chi_squared.p, 1e-4);
}

TEST(Comparison, MeasuresInStandardDeviationsOfOneRun) {
    const Summary& s = findings().cells[0].summary({QuantityKind::form_factor, 1, 2});
    const double printed = std::round((*s.mean + 3 * *s.std) * 1e6) / 1e6;
    const TableComparison c = compared(table(fmt::format("{:.6f}", printed), "0.2", "1.0", "1.0", "1.0"));
    EXPECT_NEAR(c.figures[0].z.value(), (printed - *s.mean) / *s.std, 1e-9);
    EXPECT_NEAR(c.figures[0].ours.value(), *s.mean, 1e-15);
    EXPECT_GT(c.figures[0].rank->percentile, 0.98);
    EXPECT_LT(c.figures[0].single_run->low, *s.mean);
    EXPECT_GT(c.figures[0].single_run->high, *s.mean);
}

TEST(Comparison, GivesAMisprintAnExtremeScore) {
    const TableComparison c = compared(table("0.299999", "0.200000", "1.0", "1.000000", "1.0"));
    EXPECT_GT(c.figures[0].z.value(), 5);
    EXPECT_LT(c.figures[0].adjusted_p.value(), 1e-6);
    EXPECT_GT(c.figures[1].adjusted_p.value(), 0.01);
    EXPECT_LT(c.chi_squared.at(0).form.chi_squared.p, 1e-6);
}

TEST(Comparison, UsesRanksAloneUnderInfiniteVariance) {
    Analysis infinite = findings();
    for (Summary& summary : infinite.cells[0].summaries) summary.variance = VarianceStatus::infinite;
    const auto table = compare_with_published(store(), infinite, an_honest_run()).at(0);
    for (const FigureComparison& c : table.figures) {
        EXPECT_FALSE(c.z);
        EXPECT_TRUE(c.rank);
        EXPECT_GT(c.adjusted_p.value(), 1e-3);
    }
    EXPECT_TRUE(table.chi_squared.empty());
}

TEST(Comparison, TreatsSumsFixedByClosureAsEqualOrImpossible) {
    EXPECT_EQ(compared(table("0.2", "0.2", "1.0", "1.0", "1.0")).figures[2].adjusted_p, 1.0);
    const FigureComparison wrong = compared(table("0.2", "0.2", "0.999", "1.0", "1.0")).figures[2];
    EXPECT_EQ(wrong.z, std::nullopt);
    EXPECT_EQ(wrong.adjusted_p, 0.0);
}

TEST(Comparison, JudgesErrorsByRankNotByScore) {
    const FigureComparison c = compared(table("0.2", "0.2", "1.0", "1.0", "9999.0")).figures[4];
    EXPECT_EQ(c.z, std::nullopt);
    EXPECT_EQ(c.rank->percentile, 1.0);
    EXPECT_LT(c.adjusted_p.value(), 0.1);
}

TEST(Comparison, AdjustsForAllSampledFiguresOfATable) {
    const TableComparison c = compared(table("0.299999", "0.200000", "1.0", "1.000000", "1.0"));
    // A further run's distance from the mean of 200 others: Student's t with its own and their uncertainty.
    const double alone = stats::student_two_sided_p(*c.figures[0].z / std::sqrt(1 + 1.0 / 200), 199);
    EXPECT_NEAR(c.figures[0].adjusted_p.value() / (5 * alone), 1, 1e-9);
}

TEST(Comparison, ComparesDeterministicMethodsByValue) {
    const TableComparison c = compared(table("0.2", "0.2", "1.0", "1.0", "1.0", "PDM"));
    EXPECT_TRUE(c.figures[0].deterministic);
    EXPECT_TRUE(c.figures[0].ours);
    EXPECT_FALSE(c.figures[0].z || c.figures[0].rank || c.figures[0].single_run || c.figures[0].adjusted_p);
    EXPECT_TRUE(c.chi_squared.empty());
}

TEST(Comparison, LeavesOutSizesThatTheStudyDoesNotHave) {
    PublishedTables tables = an_honest_run();
    for (Figure& figure : tables.figures) figure.samples_per_patch = 257;
    for (const FigureComparison& c : compared(tables).figures) {
        EXPECT_FALSE(c.cell || c.ours || c.z || c.adjusted_p);
    }
}

TEST(Comparison, RefusesAFaceThatTheSceneDoesNotHave) {
    PublishedTables tables = an_honest_run();
    tables.figures[0].to = "7";
    EXPECT_THROW(static_cast<void>(compare_with_published(store(), findings(), tables)), UserError);
}

TEST(FindScene, ComparesGeometryInsteadOfNames) {
    PublishedTables tables = an_honest_run();
    EXPECT_EQ(find_scene(store().plan(), tables), 0u);
    tables.scene.name = "box:6x6x6";
    EXPECT_EQ(find_scene(store().plan(), tables), 0u);
    tables.scene.name = "box:6x6x7";
    EXPECT_EQ(find_scene(store().plan(), tables), std::nullopt);
    for (const FigureComparison& c : compared(tables).figures) EXPECT_FALSE(c.cell);
}

TEST(FindCell, NeedsSceneNameAndSize) {
    const StudyPlan& plan = store().plan();
    EXPECT_EQ(find_cell(plan, 0, "SR", 4, 256), 0u);
    EXPECT_EQ(find_cell(plan, 0, "PDM", 4, std::nullopt), 1u);
    EXPECT_EQ(find_cell(plan, 0, "SR", 4, 255), std::nullopt);
    EXPECT_EQ(find_cell(plan, 0, "SR", 9, 256), std::nullopt);
    EXPECT_EQ(find_cell(plan, 0, "SRR", 4, 256), std::nullopt);
    EXPECT_EQ(find_cell(plan, 1, "SR", 4, 256), std::nullopt);
}

TEST(HalfPrintedUnit, FollowsTheDecimals) {
    EXPECT_DOUBLE_EQ(half_printed_unit("0.61"), 0.005);
    EXPECT_DOUBLE_EQ(half_printed_unit("1.0"), 0.05);
    EXPECT_DOUBLE_EQ(half_printed_unit("7"), 0.5);
}

}  // namespace
}  // namespace ff::studies
