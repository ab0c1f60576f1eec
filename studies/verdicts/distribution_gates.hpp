#pragma once

#include "studies/verdicts/gate.hpp"
#include "studies/verdicts/gate_result.hpp"
#include "studies/verdicts/known_law.hpp"
#include "studies/verdicts/reported_quantity.hpp"

#include <cstdint>
#include <span>

namespace ff::studies {

/// Values of each sample from which Anderson and Darling's statistic of two has its limiting distribution.
inline constexpr std::size_t fewest_of_two = 20;

/// How far the distribution of independent values is from a known one, in Kolmogorov's distance. Below it is limited by
/// Anderson and Darling's test, of "the distance is at most this" for any such distance; above by the band of
/// Dvoretzky, Kiefer and Wolfowitz. Nothing is known of the least distance that fails. @pre not empty
Measurement measure_distribution(std::span<const double> values, const KnownLaw& law, const Levels& levels);

/// The same of two samples.
Measurement measure_distributions(std::span<const double> first, std::span<const double> second, const Levels& levels);

/// Values that pass with the power where the distributions are the same: of each of `samples` samples.
std::uint64_t values_for_distance(double band, const Levels& levels, std::size_t samples);

/// Counts in bins against shares or against the counts of a second file, by Cohen's w (stats/count_distance.hpp).
/// @throws UserError where there are no counts, or several runs
GateResult judge_counts(const GatesSpec& spec, const Gate& gate, const Bins& bins, const Bins& against);

}  // namespace ff::studies
