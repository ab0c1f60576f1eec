#pragma once

#include "tests/support/statistical_assertions.hpp"

#include <cstdint>
#include <span>

namespace ff::test {

/// Counts of independent draws come from equally likely cells (Pearson). `risk.detects` is the root mean square
/// relative deviation of the cells' probabilities that must not go unnoticed.
testing::AssertionResult equally_likely(std::span<const std::uint64_t> counts, StatisticalRisk risk);

/// Pairs (x, y) come from independent, roughly normal variables (Fisher's z). `risk.detects` is the correlation that
/// must not go unnoticed. @pre as many x as y
testing::AssertionResult uncorrelated(std::span<const double> x, std::span<const double> y, StatisticalRisk risk);

}  // namespace ff::test
