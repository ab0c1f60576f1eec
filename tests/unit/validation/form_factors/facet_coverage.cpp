#include "tests/validation/form_factors/facet_coverage.hpp"

#include "tests/support/repetitions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace ff::studies::form_factors {
namespace {

FacetCoverage coverage_of_facets(double shrink, double shift) {
    FacetCoverageOptions options = small_facets();
    options.seeds = test::repetitions(1, 20);
    options.pairs = test::repetitions(10, 300);
    options.shrink = shrink;
    options.shift = shift;
    return measure_facet_coverage(options);
}

/// The two claims of a kind.
std::pair<ClaimVerdict, ClaimVerdict> verdicts(const FacetCoverage& coverage, const std::string& name) {
    const auto kind = std::ranges::find(coverage.kinds, name, &FacetKind::name);
    if (kind == coverage.kinds.end()) {
        ADD_FAILURE() << "nothing by " << name;
        return {};
    }
    return {verdict_of(kind->rates.rates[0], coverage.level), verdict_of(kind->rates.rates[1], coverage.level)};
}

// If rates are just as claimed, some of the 16 claims is refuted by chance with probability 0.05 at most (fixed seeds).
// With some 40 entries of a kind, a rate of 0.72 inside, or of 0.1 beyond two half widths, would be noticed with
// probability 0.9; nightly, with some 600 entries, rates of 0.9 and 0.014.
TEST(FacetCoverage, ReachesTheStatedLevel) {
    const FacetCoverage coverage = coverage_of_facets(1, 0);
    EXPECT_EQ(coverage.contradictions(), 0u);
    EXPECT_EQ(coverage.kinds.size(), 8u) << "no pair is known, or sampled, in some way";
}

TEST(FacetCoverage, FindsIntervalsBesideTheValues) {
    const FacetCoverage coverage = coverage_of_facets(1, 3);
    for (const char* name : {"cells", "points", "rays", "row sum"}) {
        EXPECT_EQ(verdicts(coverage, name).first, ClaimVerdict::fails) << name;
        EXPECT_EQ(verdicts(coverage, name).second, ClaimVerdict::fails) << name;
    }
}

// Intervals by cells and points are so cautious that a third of their width still is; rays are not. On every push some
// 40 entries by rays would show a tenth of their width, nightly hundreds show a third.
TEST(FacetCoverage, FindsTooNarrowIntervals) {
    const double shrink = test::is_nightly() ? 0.3 : 0.1;
    EXPECT_EQ(verdicts(coverage_of_facets(shrink, 0), "rays").first, ClaimVerdict::fails);
}

}  // namespace
}  // namespace ff::studies::form_factors
