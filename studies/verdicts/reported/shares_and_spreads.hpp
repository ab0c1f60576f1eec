#pragma once

#include "studies/verdicts/reported/reported_effects.hpp"

namespace ff::studies::gates {

/// The hits of all runs of a bin, of all their trials.
stats::Proportion pooled(Rows runs);

/// The difference of each bin's share from its reference, with notes. Hits of several runs are added up; where they
/// scatter more than those of independent trials, there is no verdict.
void compare_shares(BinComparison& comparing, const Bins* against);

/// Runs, each with the mean number of trials of those at hand, with which the share would be shown to lie in the band
/// if it were equal to the reference. Empty where none are enough.
/// @param runs  behind the counts of the pair
std::optional<std::uint64_t> runs_for_share(const SharePair& pair, const Band& band, std::size_t runs,
                                            const Levels& levels, std::size_t comparisons);

/// The standard deviation of a sample over the gate's reference, in each bin, from the standard errors of means.
/// @throws UserError where the file does not say of how many samples
void compare_spreads(BinComparison& comparing);

/// The efficiency over that of a second file.
/// @throws UserError where a file has several runs, or does not say of how many samples
void compare_efficiencies(BinComparison& comparing, const Bins& against);

}  // namespace ff::studies::gates
