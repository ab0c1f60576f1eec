#pragma once

#include "stats/means/mean_test.hpp"

#include <cstddef>
#include <cstdint>

namespace ff::stats {

/// The two risks of a test: alpha of rejecting a true null hypothesis, 1 - power of missing the planned effect.
struct Risks {
    double alpha = 0.05;  ///< level of this one test, in (0, 1)
    double power = 0.9;   ///< above alpha, at most 1 - 1e-9
};

/// The bias that the two-sided t test detects with the given power, in the unit of sigma. Close to (t_{alpha/2} +
/// z_beta) sigma / sqrt(trials), but exact for normal data. 0 for sigma = 0.
/// @param sigma  standard deviation of one trial, known or estimated; >= 0     @param trials  at least 2
/// @param risks  alpha of this one test: for a family of pairs, sidak_level(alpha, pairs)
double minimum_detectable_bias(double sigma, std::size_t trials, Risks risks);

/// Probability that two one-sided t tests at `alpha` find |bias| < margin, exact for normal data.
double equivalence_power(double margin, double bias, double sigma, std::size_t trials, double alpha);

/// The smallest margin within which an unbiased method passes with the given power on all `pairs` together (Bonferroni
/// over the pairs' failures; alpha needs no correction, being an intersection-union test). Close to
/// (t_alpha + z_{beta / (2 pairs)}) sigma / sqrt(trials).
double equivalence_margin(double sigma, std::size_t trials, Risks risks, std::size_t pairs = 1);

/// Trials with which equivalence_margin is at most `margin`. At least 2. @pre margin > 0, sigma > 0
std::size_t trials_for_equivalence(double margin, double sigma, Risks risks, std::size_t pairs = 1);

/// Root mean square relative deviation of the probabilities of `cells` equally likely cells that Pearson's test finds
/// with the given power (noncentral chi-squared). @pre cells >= 2, draws >= 1
double detectable_deviation(std::size_t cells, std::uint64_t draws, Risks risks);

/// The difference from 0 that a test of this evidence detects, skewness and all; infinite where it detects none.
double detectable_difference(const MeanEvidence& evidence, Risks risks);

}  // namespace ff::stats
