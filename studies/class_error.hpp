#pragma once

#include "core/pair_class.hpp"
#include "core/scene.hpp"
#include "stats/interval.hpp"
#include "studies/estimates.hpp"
#include "studies/summary.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <optional>

namespace ff::studies {

/// How large the error of one run is on the pairs of a class.
struct ClassError {
    PairClass pair_class = PairClass::other;
    std::size_t pairs = 0;
    double rmse = 0;            ///< root mean square over trials and pairs
    double mean_square_se = 0;  ///< standard error of rmse², from trial to trial; 0 for one trial
    std::size_t trials = 0;
    std::optional<stats::Interval> interval;  ///< of the RMSE; empty for a deterministic method and infinite variance
    std::optional<double> efficiency;         ///< 1 / (rmse² N), N evaluations for a face; as `interval`
    std::optional<stats::Interval> efficiency_interval;
};

/// Empty where the scene has no pair of the class, or there is no trial. The interval is Student's t for the mean over
/// trials of a trial's mean square over pairs, so that pairs of one trial may depend on each other.
/// @param variance  of the estimates of this class
/// @param level  of the intervals, in (0, 1)
std::optional<ClassError> class_error(const CellEstimates& estimates, const Scene& scene, const Eigen::MatrixXd& exact,
                                      PairClass pair_class, VarianceStatus variance, double level);

/// Interval of second.rmse / first.rmse, of independent trials: exp(ln ratio ± t s), s the standard error of the
/// logarithms by the delta method, t with one less than the fewest trials for degrees of freedom. Errors without an
/// interval count as exact; empty where both are.
std::optional<stats::Interval> rmse_ratio_interval(const ClassError& first, const ClassError& second, double level);

}  // namespace ff::studies
