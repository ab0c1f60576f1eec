#include "studies/audit/references.hpp"

#include "studies/audit/scene_facts.hpp"
#include "tests/unit/studies/audit/simulated_tables.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ff::studies::audit {
namespace {

constexpr NumberFormat six_decimals{Rounding::rounded, Layout::fixed_decimals, 6};

/// The simulated tables with relative errors of parallel pairs computed anew from `reference`.
PublishedTables with_reference(double reference, Rounding rounding) {
    PublishedTables tables = test::simulate_tables(7);
    for (std::size_t f = 1; f < tables.figures.size(); ++f) {
        Figure& error = tables.figures[f];
        const Figure& value = tables.figures[f - 1];
        const double v = parse_printed(value.printed)->value();
        const bool parallel =
            error.from + error.to == "16" || error.from + error.to == "23" || error.from + error.to == "45";
        if (error.kind != FigureKind::relative_error || !parallel) continue;
        error.printed = print(100 * std::abs(v - reference) / reference, {rounding, Layout::fixed_decimals, 2});
    }
    return tables;
}

ReferenceInference infer(const PublishedTables& tables) {
    return infer_references(tables, scene_facts(tables),
                            std::vector<NumberFormat>(tables.figures.size(), six_decimals));
}

TEST(InferReferences, KeepsTheStatedReferenceThatExplainsEverything) {
    const ReferenceInference found = infer(test::simulate_tables(7));
    ASSERT_EQ(found.references.size(), 2u);
    for (const InferredReference& r : found.references) EXPECT_NE(r.source, ReferenceSource::shortened);
    EXPECT_EQ(found.rounding, Rounding::rounded);
}

TEST(InferReferences, RecognisesAShortenedReference) {
    const ReferenceInference found = infer(with_reference(0.1998, Rounding::rounded));
    const auto& parallel = found.references[0].pair_class == "parallel" ? found.references[0] : found.references[1];
    EXPECT_EQ(parallel.source, ReferenceSource::shortened);
    EXPECT_EQ(parallel.text, "0.1998");
    EXPECT_FALSE(parallel.unexplained_by_stated.empty());
}

TEST(ErrorFits, ComparesRanges) {
    // 100 * (0.2 - 0.199044) / 0.2 = 0.478
    EXPECT_TRUE(error_fits({0.1990435, 0.1990445}, {0.475, 0.485}, 0.2));
    EXPECT_FALSE(error_fits({0.1990435, 0.1990445}, {0.485, 0.495}, 0.2));
    EXPECT_TRUE(error_fits({0.1999, 0.2001}, {0, 0.005}, 0.2));
}

}  // namespace
}  // namespace ff::studies::audit
