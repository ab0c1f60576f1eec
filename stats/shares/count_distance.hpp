#pragma once

#include "stats/basics/interval.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace ff::stats {

/// How far counts are from shares, or from other counts: the G statistic of cells that have been pooled with their
/// neighbours until at least `least_expected` are expected in each. The underlying distance is Cohen's w, roughly the
/// root mean square relative difference of shares: w² is twice the Kullback-Leibler divergence.
struct CountDistance {
    double statistic = 0;
    double freedom = 0;  ///< cells - 1
    double draws = 0;    ///< n of one sample, n m / (n + m) of two
    double spread = 1;   ///< variance of the statistic's noncentral part over that of small differences; at least 1
    double lattice = 0;  ///< largest statistic when a single event moves, from 0: counts are not continuous
    bool impossible = false;  ///< a count where the share is 0
};

/// Empty where fewer than two cells remain. @pre as many shares as counts; they add up to 1
std::optional<CountDistance> count_distance(std::span<const double> counts, std::span<const double> shares,
                                            double least_expected = 5);

/// For two samples. @pre as many cells
std::optional<CountDistance> count_distance_of_two(std::span<const double> first, std::span<const double> second,
                                                   double least_expected = 5);

/// P(G >= the observed one) where the distance is w: noncentral chi-squared, widened by `spread`. Grows with w.
double p_above(const CountDistance& found, double w);

/// All w that neither tail at (1 - level) / 2 excludes. For the upper end the statistic is taken as one event larger:
/// few events agree by chance wherever the truth lies.
Interval distance_interval(const CountDistance& found, double level);

/// The distance that is shown to exceed `band` with the given power, at a two-sided alpha.
double detectable_distance(const CountDistance& found, double band, double alpha, double power);

}  // namespace ff::stats
