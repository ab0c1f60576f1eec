#pragma once

#include "stats/basics/interval.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace ff::stats {

/// Fewest events that are expected in a cell. The moments of the statistic hold from here on.
inline constexpr double least_expected = 5;

/// How far counts are from shares, or from other counts: the G statistic of cells that have been pooled with their
/// neighbours until at least `least_expected` are expected in each. The underlying distance is Cohen's w, roughly the
/// root mean square relative difference of shares: w² is twice the Kullback-Leibler divergence.
struct CountDistance {
    double statistic = 0;  ///< G less its bias at few events: its mean is at most freedom + draws w²
    double empty = 0;      ///< amount to add to the statistic so that its mean is at least that
    double freedom = 0;    ///< cells - 1
    double variance = 0;   ///< variance of the statistic where nothing differs; at least 2 freedom
    double draws = 0;      ///< n of one sample, n m / (n + m) of two
    double spread = 1;     ///< variance of the statistic's noncentral part over that of small differences; at least 1
    double lattice = 0;    ///< largest statistic when a single event moves, from 0: counts are not continuous
};

/// Empty where fewer than two cells remain. @pre as many shares as counts; they add up to 1
std::optional<CountDistance> count_distance(std::span<const double> counts, std::span<const double> shares);

/// The distance between two samples. @pre as many cells
std::optional<CountDistance> count_distance_of_two(std::span<const double> first, std::span<const double> second);

/// The bin whose count refutes most clearly, at `alpha` over all bins where less than `least_expected` events are
/// expected, that the distribution lies within a distance of w; pooling would hide it. Empty where none does. By
/// Chernoff's bound. @pre as many shares as counts; they add up to 1
std::optional<std::size_t> refuting_bin(std::span<const double> counts, std::span<const double> shares, double w,
                                        double alpha);

/// P(G >= the observed one) where the distance is w: noncentral chi-squared, as wide as `variance`
/// and `spread` say. Grows with w.
double p_above(const CountDistance& found, double w);

/// All w that neither tail at (1 - level) / 2 excludes. For the upper end the statistic is taken as one event larger:
/// few events agree by chance wherever the truth lies.
Interval distance_interval(const CountDistance& found, double level);

/// The distance that is shown to exceed `band` with the given power, at a two-sided alpha.
double detectable_distance(const CountDistance& found, double band, double alpha, double power);

}  // namespace ff::stats
