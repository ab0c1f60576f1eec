#pragma once

#include "stats/means/mean_test.hpp"
#include "studies/comparison/run_comparison.hpp"
#include "studies/trials/estimates.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace ff::studies {

enum class Tested { mean, spread, rmse };

/// A test of one pair, or of a class of pairs; `cell` is an index into the comparison.
struct Test {
    std::size_t cell = 0;
    Tested tested = Tested::mean;
    Contrast contrast{};
    double p = 1;
    std::size_t ratio = 0;                                    ///< index into the cell's ratios, for a test of RMSEs
    std::optional<std::array<stats::Measured, 2>> spreads{};  ///< ln(variance) of both, for a test of these
    std::optional<stats::MeanEvidence> means{};               ///< their difference, for a test of these
};

/// Adds both tests of every pair that has them. @param index  of the cell in the comparison
void test_pairs(const CellEstimates& a, const CellEstimates& b, const Analysis& first, const Analysis& second,
                const std::vector<Quantity>& pairs, std::size_t index, CellComparison& cell, std::vector<Test>& tests);

/// Adds those of classes: all pairs of one together reveal a small difference that they share, which no single pair
/// shows.
void test_classes(std::size_t index, const CellComparison& cell, std::vector<Test>& tests);

/// Shares the error rate among all tests, and judges the cells by them.
void judge_cells(const std::vector<Test>& tests, RunComparison& comparison);

}  // namespace ff::studies
