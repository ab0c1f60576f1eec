#pragma once

#include "studies/verdicts/gate.hpp"
#include "studies/verdicts/gate_result.hpp"
#include "studies/verdicts/reported/reported_quantity.hpp"

#include <cstdint>
#include <span>

namespace ff::studies::gates {

/// Fewest values per sample for which Anderson and Darling's two-sample statistic has its limiting distribution.
inline constexpr std::size_t fewest_of_two = 20;

/// The distance of the distribution of independent values from a known one, in Kolmogorov's metric. Its lower limit
/// comes from Anderson and Darling's test of "the distance is at most this", its upper limit from the band of
/// Dvoretzky, Kiefer and Wolfowitz. The least distance that fails is unknown. @pre not empty
Measurement measure_distribution(std::span<const double> values, const KnownLaw& law, const Levels& levels);

/// The same for two samples.
Measurement measure_distributions(std::span<const double> first, std::span<const double> second, const Levels& levels);

/// Number of values, in each of `samples` samples, with which equal distributions pass with the given power.
std::uint64_t values_for_distance(double band, const Levels& levels, std::size_t samples);

/// Counts in bins against shares or against the counts of a second file, by Cohen's w
/// (stats/shares/count_distance.hpp).
/// @throws UserError where there are no counts, or several runs
GateResult judge_counts(const Spec& spec, const Gate& gate, const Bins& bins, const Bins& against);

}  // namespace ff::studies::gates
