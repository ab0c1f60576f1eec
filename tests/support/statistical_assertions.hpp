#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <span>

namespace ff::test {

/// The two risks of a statistical assertion. It fails when the data contradict the claim (a false alarm has
/// probability `alpha`) and also when they are too noisy, or too few, to have noticed an effect of size `detects` with
/// probability `power`: a test that cannot fail is worthless.
struct StatisticalRisk {
    double alpha = 1e-6;
    double detects = 0;   ///< effect that must not go unnoticed, in units of the quantity itself; > 0
    double power = 0.99;  ///< probability with which that effect is noticed
};

/// Independent replicates scatter around `truth` (two-sided t test). Fails for fewer than two values or equal ones.
testing::AssertionResult unbiased(std::span<const double> replicates, double truth, StatisticalRisk risk);

/// The hit probability behind `hits` of `trials` independent trials is `probability` (exact two-sided binomial test,
/// exact power); e.g. the coverage of an interval, the level of a test, a coordinate's share of a cell.
testing::AssertionResult has_probability(std::uint64_t hits, std::uint64_t trials, double probability,
                                         StatisticalRisk risk);

/// It is at least / at most `probability` (one-sided): coverage that may be larger, a level that may be smaller.
testing::AssertionResult has_probability_at_least(std::uint64_t hits, std::uint64_t trials, double probability,
                                                  StatisticalRisk risk);
testing::AssertionResult has_probability_at_most(std::uint64_t hits, std::uint64_t trials, double probability,
                                                 StatisticalRisk risk);

}  // namespace ff::test
