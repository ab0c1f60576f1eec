#pragma once

#include "core/points/stream.hpp"

#include <optional>
#include <span>
#include <vector>

namespace ff::stats {

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
