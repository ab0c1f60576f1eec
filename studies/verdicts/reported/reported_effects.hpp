#pragma once

#include "studies/verdicts/measurement.hpp"
#include "studies/verdicts/reported/reported_bins.hpp"
#include "studies/verdicts/reported/reported_quantity.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies::gates {

/// Everything that the text of a verdict is made from.
struct BinComparison {
    const Gate& gate;
    Bins bins;
    BinEffects effects;
    std::size_t empty = 0;      ///< bins without any sample
    bool contradicted = false;  ///< runs scatter otherwise than the verdict would have to assume: there is none
    std::string note;

    /// Adds the ratio of a bin, whose band is the gate's.
    void add_ratio(std::size_t bin, double value, double freedom, double freedom_below);
};

/// Rate at which runs that keep an assumption are said to contradict it.
inline constexpr double false_alarm_of_scatter = 1e-3;

/// The mean of all runs of a bin with its standard error: by what the runs state, or by their spread where they are
/// many. The error is 0 where none is stated.
MeanReference mean_of(Rows runs);

/// Whether no sample fell into a bin of means: it has neither mean nor error, where errors are stated or many runs show
/// them. Values without errors are exact.
/// @throws UserError where many runs have one mean, not 0
bool is_empty(const Gate& gate, const Bins& bins, std::size_t bin);

/// The gate's band in one bin, whose reference scales it where it is relative.
Band band_beside(const BinComparison& comparing, std::size_t bin, double reference);

/// Appends to the note, after a semicolon if there is one already.
void add_note(std::string& note, std::string_view text);

/// The effect in each bin, with notes.
/// @param against  null where the reference is a number
/// @throws UserError where the file lacks what the kind needs
BinComparison effects_of(const Gate& gate, const Bins& bins, const Bins* against);

// What gates of different kinds compare, each in a file of its own.

/// The standard deviation of a sample over the gate's reference, in each bin, from the standard errors of means.
/// @throws UserError where the file does not say of how many samples
void compare_spreads(BinComparison& comparing);

/// The efficiency over that of a second file.
/// @throws UserError where a file has several runs, or does not say of how many samples
void compare_efficiencies(BinComparison& comparing, const Bins& against);

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

/// The p-value of "every effect lies in its band", of all bins together, by Hotelling's T² with the covariance that the
/// gate's file has: columns bin, other_bin and covariance, each pair once. Holds for normal means. With errors from n
/// samples, the covariance is assumed to come from the same samples.
/// @param effects  differences; not empty
/// @throws IoError; UserError where the file is malformed, lacks a pair, disagrees with the standard errors, or is not
///   a possible covariance of that many bins
double p_by_covariance(const Gate& gate, const Bins& bins, const std::vector<BinEffect>& effects);

// Common mistakes of codes in reporting a mean and its error, recognised by the size of the discrepancy. Hints, never
// verdicts: a sentence with a full stop, empty where nothing fits.

/// @param ratio  spread of means between runs over the errors stated    @param error  a typical one as stated
/// @param n      samples behind a mean; 0 where not stated
std::string fault_of_errors(double ratio, double error, double n);

/// Sums instead of means: one file's values are n times the other's, in all bins together.
/// @pre rows of the same bins in the same order; `against` may have one row only
std::string fault_of_means(Rows rows, Rows against);

/// Variances instead of standard errors in one of two files.
std::string fault_between_errors(Rows rows, Rows against);

}  // namespace ff::studies::gates
