#pragma once

#include "core/points/stream.hpp"
#include "stats/basics/binomial.hpp"
#include "tests/validation/form_factors/facet_scenes.hpp"
#include "tests/validation/form_factors/plain_reference.hpp"
#include "tests/validation/rates/measured_rate.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ff::studies::form_factors {

struct FacetCoverageOptions {
    Seed seed{1};  ///< the first seed
    std::uint64_t seeds = 100;
    std::size_t pairs = 1600;  ///< drawn for each method in each scene, at each tolerance; all where there are fewer
    unsigned threads = 1;
    double shrink = 1;  ///< factor on the width of every sampled interval; below 1: a control to be caught
    double shift = 0;   ///< shift of every sampled interval, in half widths: another control
    ReferenceEffort effort;
    FacetScenes scenes = FacetScenes::large;
};

/// A request with small scenes and coarse references, which takes seconds.
FacetCoverageOptions small_facets();

/// Entries that one method gave, or sums of rows.
struct FacetKind {
    std::string name;
    /// Rates over one entry of each pair, so that entries are independent: the two claims, then the same scene by
    /// scene.
    RateTable rates;
    stats::Proportion inside;          ///< entries inside their intervals, of all entries with all seeds
    stats::Proportion beyond;          ///< entries beyond two half widths
    stats::Proportion fine;            ///< entries inside, of those whose reference is at least ten times as narrow
    double worst = 0;                  ///< farthest distance from the interval, in half widths
    std::vector<std::string> outside;  ///< the entries that are farthest outside, some of them
};

/// How often intervals of facets contain references of a hundred times the accuracy.
struct FacetCoverage {
    FacetCoverageOptions options;
    std::string scenes;  ///< their names and sizes
    std::vector<FacetKind> kinds;
    std::size_t references = 0;
    std::size_t wide_references = 0;  ///< references that do not reach their accuracy
    double level = 0;  ///< level of the interval of one rate, such that all hold together with 0.95 (Sidak)

    [[nodiscard]] std::size_t contradictions() const;  ///< claims that the intervals exclude
};

/// What an interval says of a claim.
enum class ClaimVerdict { holds, fails, open };
ClaimVerdict verdict_of(const MeasuredRate& rate, double level);

/// Computes the matrices with many seeds at 1e-4 and 1e-3, and by rays at 1e-3, and compares entries with references
/// of 1e-6. Entries that lie outside both their own interval and the reference's are compared again, each with a new
/// reference of 32 randomisations at level 0.999: few of the first references miss, but all that miss look like errors
/// of entries.
FacetCoverage measure_facet_coverage(const FacetCoverageOptions& options);

}  // namespace ff::studies::form_factors
