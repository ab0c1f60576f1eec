#pragma once

#include "stats/interval.hpp"
#include "stats/moments.hpp"

#include <optional>

namespace ff::stats {

/// Welch's test of "both means are equal": variances may differ, and one of the two may be 0. @see [welch1947]
struct MeanDifference {
    double difference = 0;  ///< second mean - first
    double standard_error = 0;
    double freedom = 0;  ///< of Welch and Satterthwaite
    double p = 0;        ///< two-sided
};

/// Empty below two values in a sample and where neither varies. @pre equal references, near both means
std::optional<MeanDifference> test_means_welch(const Moments& first, const Moments& second);

}  // namespace ff::stats
