#pragma once

#include "stats/basics/interval.hpp"
#include "stats/means/mean_test.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace ff::stats {

/// A number made of independent means: the logarithm of a mean square, a weighted sum of such logarithms, a slope. Two
/// of them are compared by their difference.
struct Measured {
    struct Part {
        MeanEvidence mean;       ///< MeanEvidence::difference is the mean itself
        double weight = 1;       ///< not 0
        bool logarithm = false;  ///< the part is the logarithm of the mean, which is positive
    };

    double value = 0;
    std::vector<Part> parts;  ///< empty where the number is exact

    [[nodiscard]] bool is_exact() const { return parts.empty(); }

    /// How far the truth may be above (side 1) or below (side -1) the value, except with probability `tail`. Reaches of
    /// parts, each by the rule for means, are added as squares [zou2008]; what all evaluations may have missed adds to
    /// the upper one of a mean. Infinite where the trials of a part are too
    /// few or too skewed.
    [[nodiscard]] double reach(int side, double tail) const;
};

/// ln(scale * mean). @pre mean.difference > 0
Measured logarithm_of(const MeanEvidence& mean, double scale = 1);

/// A number with a normal error of its own. @pre standard_error >= 0, trials > 1
Measured with_error(double value, double standard_error, std::size_t trials);

/// Interval of second - first. Ends may be infinite. Empty where both are exact.
/// @param correlation  of both; for numbers from the same trials
std::optional<Interval> difference_interval(const Measured& first, const Measured& second, double level,
                                            double correlation = 0);

/// Two-sided p of equal numbers: 1 - the highest level at which the interval of their difference leaves 0 out.
double p_of_equal(const Measured& first, const Measured& second);

}  // namespace ff::stats
