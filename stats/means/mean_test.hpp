#pragma once

#include "stats/basics/interval.hpp"
#include "stats/dependence/correlation.hpp"
#include "stats/gates/skewed_reach.hpp"
#include "stats/means/mean_interval.hpp"

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace ff::stats {

/// The one rule for means: whatever is said of a mean of trials (its bias, its equivalence, its difference from another
/// one) rests on these intervals and p-values, which allow for skewness as far as the values may have it
/// (stats/gates/skewed_reach.hpp).

/// Values are often means themselves, of independent parts. Where no part moves a value by more than `largest_part`, a
/// value's third moment is at most that times its variance, so that its skewness is at most largest_part / standard
/// deviation. Infinite where nothing is known; 0 for values that are known not to be skewed.
inline constexpr double unknown_parts = std::numeric_limits<double>::infinity();
inline constexpr double no_part = 0;

/// A value that the evaluations behind all values may have missed. Places that make up a share p of all are met by none
/// of n evaluations with probability (1 - p)^n, if they are spread no less evenly than independent ones.
struct Unmet {
    double largest = 0;      ///< value at such places; 0 where there are none
    double evaluations = 1;  ///< n

    /// The share of a tail that goes to the values that were met, where something may have been missed: 9/10, since the
    /// reach of what was missed hardly depends on its share.
    [[nodiscard]] double tail_of_met(double tail) const { return largest > 0 ? 0.9 * tail : tail; }
    [[nodiscard]] double tail_of_unmet(double tail) const { return 0.1 * tail; }

    /// How far the mean may be off because of it, except with probability `tail`: largest * p, with (1 - p)^n = tail.
    [[nodiscard]] double reach(double tail) const;
};

/// The limits of values that follow from the way in which they are made.
struct KnownLimits {
    double largest_part = unknown_parts;
    Unmet unmet;
    double rounding = 0;  ///< bound of the errors of arithmetic, in the values and in their reference
};

/// A mean beside its reference, or beside another mean, and all that is needed to judge the difference.
struct MeanEvidence {
    double difference = 0;  ///< mean - reference, or second mean - first
    double standard_error = 0;
    double freedom = 0;  ///< degrees of freedom of the standard error
    gate::MeanSkewness skewness;
    Unmet unmet = {};         ///< adds to what the standard error says; both then share a tail
    double rounding = 0;      ///< adds to it in any case
    double unseen = 0;        ///< adds above the mean in any case: what so few values of a long upper tail may not show
    std::string_view method;  ///< how intervals are found: "skewed_t", "skewed_welch_t" or "stein_two_stage"
    std::size_t n = 0;        ///< values behind it

    [[nodiscard]] double t() const { return difference / standard_error; }
    /// How far the mean of the values that were met may be off on one side (-1 or 1), except with its part of `tail`.
    [[nodiscard]] double reach_of_met(int side, double tail) const;
};

/// Limits for values that are known not to be skewed.
inline constexpr KnownLimits not_skewed{.largest_part = no_part, .unmet = {}, .rounding = 0};

/// A mean of independent values, or of correlated ones in order.
/// @return empty below three values, for values that are all equal, and where correlated ones are worth less than two
std::optional<MeanEvidence> mean_evidence(std::span<const double> values, double reference,
                                          const KnownLimits& limits = {},
                                          const std::optional<Autocorrelation>& correlation = {});

/// A mean of values whose number was fixed by a pilot, the first of them.
MeanEvidence mean_evidence_after(const Pilot& pilot, std::span<const double> values, double reference,
                                 const KnownLimits& limits = {});

/// Welch's difference of two means, whose variances may differ, and one of which may be 0. @see [welch1947]
/// @return empty below three values in a sample, and where neither varies
std::optional<MeanEvidence> difference_of_means(std::span<const double> first, std::span<const double> second);

/// The same mean beside a reference that has a standard error, its degrees of freedom, and the skewness of a mean.
MeanEvidence with_uncertain_reference(const MeanEvidence& mean, double standard_error, double freedom,
                                      const gate::MeanSkewness& skewness = {.most = no_part});

/// Interval of the difference. An end is infinite where the values are too skewed, or too few, for the level.
Interval interval_of(const MeanEvidence& mean, double level);

/// Interval of the mean less the reference. Empty below three values, for values that are all equal, and where an end
/// would be infinite.
std::optional<Interval> mean_interval(std::span<const double> values, double reference, double level,
                                      const KnownLimits& limits = {});

/// Test of "there is no difference", two-sided. A large p does not prove that there is none: print the minimum
/// detectable bias (stats/error_rates/power.hpp) beside it, or show that the interval lies within a margin.
struct MeanTest {
    double p = 1;          ///< 1 - the highest level at which the interval leaves 0 out
    double student_p = 1;  ///< p-value of Student's t test, for values without skewness; never above `p`
};
MeanTest test_mean(const MeanEvidence& mean);

/// Twice the smallest tail at which an interval leaves 0 out.
/// @param leaves_out  whether the interval with this tail beyond each end does
/// @param least       what p cannot be below
double two_sided_p(const std::function<bool(double tail)>& leaves_out, double least = 0);

/// A value that would explain a difference, and how often it could occur without any of n trials showing it, except
/// with probability `tail`. No rule can exclude such a law [bahadur1956].
struct UnseenValue {
    double value = 0;
    double one_in = 0;  ///< it occurs once in so many trials, at most
};
/// @param mean  mean of the trials, which have missed the value @param reference  the true mean
UnseenValue unseen_value(double mean, double reference, std::size_t n, double tail);

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
    /// parts, each by the rule for means, are added as squares [zou2008]; what all evaluations may have missed, and
    /// what so few values may not show, adds to the upper one of a mean. Infinite where the trials of a part are too
    /// few or too skewed.
    [[nodiscard]] double reach(int side, double tail) const;
    [[nodiscard]] double standard_error() const;
};

/// ln(scale * mean). @pre mean.difference > 0
Measured logarithm_of(const MeanEvidence& mean, double scale = 1);

/// A number with a normal error of its own. @pre standard_error >= 0, trials > 1
Measured with_error(double value, double standard_error, std::size_t trials);

/// Interval of second - first. Ends may be infinite. Empty where both are exact.
/// @param correlation  correlation of both, where they are from the same trials
std::optional<Interval> difference_interval(const Measured& first, const Measured& second, double level,
                                            double correlation = 0);

/// Two-sided p of equal numbers: 1 - the highest level at which the interval of their difference leaves 0 out.
double p_of_equal(const Measured& first, const Measured& second);

}  // namespace ff::stats
