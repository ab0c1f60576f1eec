#pragma once

#include "core/exact/known_factors.hpp"
#include "core/geometry/fwd.hpp"
#include "core/visibility/pair_class.hpp"
#include "stats/basics/interval.hpp"
#include "stats/means/mean_test.hpp"
#include "studies/analysis/summary.hpp"
#include "studies/trials/estimates.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace ff::studies {

/// The error of one run on all pairs of a class together. Intervals rest on one value per trial, so that pairs of a
/// trial may depend on each other.
struct ClassError {
    PairClass pair_class = PairClass::other;
    std::size_t pairs = 0;
    std::size_t trials = 0;
    std::uint64_t evaluations = 0;  ///< N: what a trial costs, per face (CellEstimates)
    VarianceStatus status = VarianceStatus::finite;
    double rmse = 0;  ///< root mean square over trials and pairs; without a variance, for these trials only
    /// The mean square as it varies from trial to trial; empty where the variance is not finite, and for few trials.
    std::optional<stats::MeanEvidence> mean_square;
    std::optional<stats::Interval> interval;  ///< interval of the RMSE; empty also where an end is 0 or infinite
    double median_abs_error = 0;
    double bias = 0;  ///< mean over pairs
    std::optional<stats::Interval> bias_interval;
    std::optional<double> variance;                        ///< mean over pairs, of one trial
    std::optional<stats::MeanEvidence> squared_deviation;  ///< a trial's mean over pairs, about each pair's own mean
    std::optional<stats::Interval> variance_interval;      ///< empty as `interval`
    std::optional<double> efficiency;                      ///< 1 / (rmse² N)
    std::optional<stats::Interval> efficiency_interval;
};

/// The value that all evaluations of all trials of a pair may have missed.
using UnmetOf = std::function<stats::Unmet(Quantity pair)>;

/// Empty where no pair of the class has an exact value, or there is no trial.
/// @param pairs  distinct ones
/// @param status  of the estimates of this class: intervals and efficiency need a finite variance
/// @param level  of the intervals, in (0, 1)
std::optional<ClassError> class_error(const CellEstimates& estimates, const Scene& scene, const KnownFactors& known,
                                      std::span<const Quantity> pairs, PairClass pair_class, VarianceStatus status,
                                      double level, const UnmetOf& unmet_of);

/// The same from errors, [trial * pairs + pair]; the class is not set. @pre at least one trial
/// @param unmet  `unmet_squares` of the pairs; none where nothing is known
ClassError class_error_of(std::span<const double> errors, std::size_t pairs, std::uint64_t evaluations,
                          VarianceStatus status, double level, const stats::Unmet& unmet = {});

/// The part of a trial's mean square error over these pairs that values met by no evaluation may add: one of the n
/// samples of a pair moves the trial by its value / n, and all n may do so.
stats::Unmet unmet_squares(const std::vector<stats::Unmet>& pairs, std::uint64_t samples_of_pair);

/// Estimate - exact value, [trial * pairs + pair]. @pre all pairs have one
std::vector<double> errors_of(const CellEstimates& estimates, std::span<const Quantity> pairs,
                              const KnownFactors& known);

/// The pairs among these that have an exact value.
std::vector<Quantity> known_pairs(std::span<const Quantity> pairs, const KnownFactors& known);

/// The pairs of the class that face each other: others are exactly 0, without error.
std::vector<Quantity> pairs_of_class(const Scene& scene, std::span<const Quantity> pairs, PairClass wanted);

/// The pairs of a cell that are distinct and have an exact value.
std::vector<Quantity> known_pairs_of_class(const StudyPlan& plan, const Cell& cell, const KnownFactors& known,
                                           PairClass wanted);

/// ln RMSE. Empty for trials without a finite variance, and for few trials.
/// @param certain  no trials would show more: the method is deterministic, or its error is rounding
std::optional<stats::Measured> log_rmse(const ClassError& error, bool certain = false);

/// ln of the variance. @pre there is a squared_deviation
stats::Measured log_variance(const ClassError& error);

/// Interval of the ratio exp(second - first). Ends may be 0 or infinite. Empty where both are exact.
std::optional<stats::Interval> ratio_interval(const stats::Measured& first, const stats::Measured& second, double level,
                                              double correlation = 0);

}  // namespace ff::studies
