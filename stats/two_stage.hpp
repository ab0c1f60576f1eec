#pragma once

#include "stats/bias_test.hpp"
#include "stats/interval.hpp"
#include "stats/moments.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace ff::stats {

/// Stein's two stages [stein1945]: the spread of the first values, the pilot, fixes the total number n. For normal
/// values the mean of all n is independent of that spread, so that sqrt(n) (mean - truth) / s of the pilot has exactly
/// Student's t distribution with the pilot's degrees of freedom: intervals keep their coverage although n was chosen by
/// looking at the data. Intervals with the standard deviation of all values do not keep it.
struct Pilot {
    std::size_t n = 0;              ///< values, >= 2
    double standard_deviation = 0;  ///< of the pilot alone, > 0
};

/// The first n of the values; empty where they do not vary or are fewer. @pre n >= 2
std::optional<Pilot> pilot_of(std::span<const double> values, std::size_t n);

/// Half-width of the interval of a mean of `trials` values: t(n - 1) s / sqrt(trials). @pre trials >= pilot.n
double half_width_of(Pilot pilot, std::uint64_t trials, double level);

/// Upper bound, on average over pilots, of the root mean squared error of a mean of `trials` values: s sqrt((n - 1) /
/// (n - 3) / trials), since E(sigma^2 / s^2) = (n - 1) / (n - 3) for n normal values.
/// @pre pilot.n >= 4, trials >= pilot.n
double rmse_of(Pilot pilot, std::uint64_t trials);

/// Total number of values for a half-width of at most `half_width`, at least the pilot's.
/// @pre half_width > 0
std::uint64_t trials_for_half_width(Pilot pilot, double half_width, double level);

/// Total number of values for a root mean squared error of the mean of at most `rmse`. @pre pilot.n >= 4, rmse > 0
std::uint64_t trials_for_rmse(Pilot pilot, double rmse);

/// mean - reference +- t(pilot.n - 1) s / sqrt(n), s and degrees of freedom of the pilot, method "stein_two_stage".
/// @pre the pilot's values are the first of `all`
Interval bias_interval_two_stage(const Moments& all, Pilot pilot, double level);

/// Tests of "mean = reference" and of "|mean - reference| >= margin" in the same way; without a pilot, the tests of
/// stats/bias_test.hpp.
std::optional<BiasTest> test_bias(const Moments& all, const std::optional<Pilot>& pilot);
std::optional<EquivalenceTest> test_equivalence(const Moments& all, const std::optional<Pilot>& pilot, double margin,
                                                double alpha);

}  // namespace ff::stats
