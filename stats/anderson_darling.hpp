#pragma once

#include <cstddef>
#include <span>

namespace ff::stats {

/// P(A² > z) of the Anderson-Darling statistic of many values, by Smirnov's formula for sums of squares of normal
/// numbers, to ten digits for p below 1/2. From 10 values of one sample on it is right to a twentieth; for two samples
/// it is an upper bound in the tail from 20 values on. @see [anderson1952], [scholz1987] @pre z >= 0
double anderson_darling_tail(double z);

/// The smallest A² of any uniform numbers that lie nowhere further than `tolerance` from these, so that it is no larger
/// than A² of uniform numbers where the distribution of these is uniform up to `tolerance` everywhere: p-values made of
/// it hold for that hypothesis whatever the distribution is, and are the usual ones for a tolerance of 0.
/// @pre sorted, in [0, 1]; at least one
double anderson_darling(std::span<const double> uniform, double tolerance);

/// Of two samples: differences of the empirical distributions that are no larger than `tolerance` do not count, and
/// larger ones count by what exceeds it, in terms of the largest variance that is possible there. A bound in every
/// point, not of the whole sum: levels at the end of a tolerance are measured, not proven.
/// @pre both sorted and not empty
double anderson_darling(std::span<const double> first, std::span<const double> second, double tolerance);

/// Largest distance of the empirical distributions, and of that of uniform numbers from the uniform one.
/// @pre sorted, not empty
double kolmogorov_distance(std::span<const double> uniform);
double kolmogorov_distance(std::span<const double> first, std::span<const double> second);

}  // namespace ff::stats
