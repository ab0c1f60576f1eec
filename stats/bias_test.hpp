#pragma once

#include "stats/interval.hpp"
#include "stats/moments.hpp"

#include <cstddef>
#include <optional>

namespace ff::stats {

/// Student's test of "mean = reference". A large p does not prove unbiasedness: print the minimum detectable bias
/// (stats/power.hpp) beside it, or test equivalence.
struct BiasTest {
    double bias = 0;            ///< mean - reference
    double standard_error = 0;  ///< of the mean
    double t = 0;
    double freedom = 0;  ///< n - 1
    double p = 0;        ///< two-sided
};

/// Empty below two values and where all are equal.
std::optional<BiasTest> test_bias(const Moments& moments);

/// Two one-sided tests of "|bias| >= margin" [schuirmann1987].
struct EquivalenceTest {
    Interval interval;        ///< of the bias, level 1 - 2 alpha
    double margin = 0;        ///< > 0
    double p = 0;             ///< the larger of the two one-sided p-values
    bool equivalent = false;  ///< the interval lies inside +- margin, i.e. p < alpha
    bool different = false;   ///< the interval lies wholly outside +- margin
};

/// Empty below two values and for values that are all equal. @pre 0 < alpha < 0.5, margin > 0
std::optional<EquivalenceTest> test_equivalence(const Moments& moments, double margin, double alpha);

}  // namespace ff::stats
