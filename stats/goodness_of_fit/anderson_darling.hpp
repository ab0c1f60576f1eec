#pragma once

#include "core/points/stream.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace ff::stats {

/// P(A² > z) of the Anderson-Darling statistic of many values, by Smirnov's formula for sums of squares of normal
/// numbers, to ten digits for p below 1/2. It is right to 5 % from 10 values of one sample on; for two samples it is an
/// upper bound in the tail from 20 values on. @see [anderson1952], [scholz1987] @pre z >= 0
double anderson_darling_tail(double z);

/// The smallest A² among all samples within `tolerance` of these values. It is at most A² of a uniform sample if the
/// distribution of the values is within `tolerance` of uniform everywhere: its p-values hold for that hypothesis,
/// whatever the distribution, and are the usual ones for a tolerance of 0.
/// @pre sorted, in [0, 1]; at least one
double anderson_darling(std::span<const double> uniform, double tolerance);

/// A² of two samples: differences of their empirical distributions up to `tolerance` do not count, and larger ones
/// count by their excess, relative to the largest variance possible there. This bounds every term, not the whole sum:
/// levels at the end of a tolerance are measured, not proved.
/// @pre both sorted and not empty
double anderson_darling(std::span<const double> first, std::span<const double> second, double tolerance);

/// Largest distance between two empirical distributions, and between one and the uniform distribution.
/// @pre sorted, not empty
double kolmogorov_distance(std::span<const double> uniform);
double kolmogorov_distance(std::span<const double> first, std::span<const double> second);

/// Half-width of the Dvoretzky-Kiefer-Wolfowitz band around an ECDF of n values: sqrt(ln(2/(1-level)) / (2n)).
/// Coverage >= level for every distribution, discrete ones included. @see [massart1990]
double dkw_half_width(std::size_t n, double level);

/// Anderson-Darling test of normality with unknown mean and variance [stephens1986].
struct NormalityTest {
    double statistic = 0;  ///< A^2
    double adjusted = 0;   ///< A^2 (1 + 0.75/n + 2.25/n^2)
    double p = 0;          ///< approximate; an upper bound where it is 4e-24 (adjusted >= 10)
};

/// Empty below eight values and where all are equal. Discrete data are rejected for being discrete alone: jitter hit
/// counts first.
std::optional<NormalityTest> test_normality(std::span<const double> values);

/// Adds a uniform number within +- spacing/2 to each value, so that numbers on a lattice (hit counts / rays, spacing
/// 1 / rays) get a density. Seeded. @pre spacing > 0
std::vector<double> jitter_lattice(std::span<const double> values, double spacing, StreamKey key);

}  // namespace ff::stats
