#include "tests/validation/form_factors/coverage.hpp"

#include <gtest/gtest.h>

namespace ff::studies::form_factors {
namespace {

/// Three scenes of rays, level 0.95 of each entry and of the matrix.
FormFactorCoverage coverage_of(double shrink, std::uint64_t seeds) {
    FormFactorCoverageOptions options;
    options.seeds = seeds;
    options.tolerance = 4e-3;
    options.threads = 2;
    options.shrink = shrink;
    options.cells = false;
    options.scenes = {"squares_blocked", "discs_blocked", "squares_through_aperture", "cube_adjacent_faces"};
    return measure_form_factor_coverage(options);
}

// Six rates, each claimed to be at least 0.95: one of them falls below its interval, at level 1 - 0.05 / 6, with
// probability 0.05 at most if all are 0.95 (fixed seeds). Coverage of 0.83 is noticed with probability 0.9 in each:
// P(X <= 88) for X ~ B(100, 0.83), 88 being the most whose interval ends below 0.95.
TEST(FormFactorCoverage, ReachesTheStatedLevel) {
    const FormFactorCoverage coverage = coverage_of(1, 100);
    EXPECT_EQ(coverage.contradictions(), 0u);
    EXPECT_EQ(coverage.entries.rates.size(), 3u);
    EXPECT_EQ(coverage.matrices.rates.size(), 3u);
    EXPECT_EQ(coverage.exact_pairs, 1u);
    EXPECT_EQ(coverage.exact_missed, 0u);
    EXPECT_EQ(coverage.out_of_tolerance, 0u);
}

// Half the width holds about 0.71 of all values where it should hold 0.955 (Student's t, 15 degrees of freedom).
// A rate falls below its interval up to 69 of 80: all six do with probability 0.997.
TEST(FormFactorCoverage, FallsShortWhereIntervalsAreTooNarrow) {
    EXPECT_EQ(coverage_of(0.5, 80).contradictions(), 6u);
}

}  // namespace
}  // namespace ff::studies::form_factors
