#include "studies/trials/estimates.hpp"

#include "tests/support/studies.hpp"

#include <gtest/gtest.h>

namespace ff::studies {
namespace {

constexpr std::string_view three_sizes = R"([[method]]
name = "SR"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = [4, 8, 16]
)";

TEST(CellReader, ReadsACellOnceWhileThereIsRoom) {
    const Store store = test::run(test::plan_of(test::study_text("trials = 10", three_sizes)));
    const CellReader cells(store);
    const auto first = cells.load(0);
    EXPECT_NE(cells.load(1), first);
    EXPECT_EQ(cells.load(0), first) << "it was not read again";
    EXPECT_EQ(first->factors, load_estimates(store, 0).factors);
}

TEST(CellReader, KeepsTheCellsUsedLast) {
    const Store store = test::run(test::plan_of(test::study_text("trials = 10", three_sizes)));
    // Of 10 trials: their numbers, 36 pairs (6 of them empty), 6 row sums and the sum of errors.
    constexpr std::size_t bytes_of_a_cell = 10 * (1 + 30 + 6 + 1) * sizeof(double);
    const CellReader two(store, bytes_of_a_cell);
    const auto first = two.load(0);
    const auto second = two.load(1);
    EXPECT_EQ(two.load(0), first);
    const auto third = two.load(2);
    EXPECT_EQ(two.load(0), first);
    EXPECT_NE(two.load(1), second) << "it was used least recently";
    const CellReader none(store, 0);
    const auto once = none.load(0);
    EXPECT_EQ(none.load(0), once) << "the last one is always kept";
    EXPECT_EQ(none.load(1)->cell, 1u);
    EXPECT_NE(none.load(0), once);
}

}  // namespace
}  // namespace ff::studies
