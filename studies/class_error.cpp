#include "studies/class_error.hpp"

#include "stats/distributions.hpp"
#include "stats/mean_interval.hpp"
#include "stats/moments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ff::studies {
namespace {

/// Interval of 1 / (x N) from that of sqrt(x): the ends change places.
stats::Interval efficiency_interval(stats::Interval rmse, double evaluations) {
    const double high = 1 / (rmse.low * rmse.low * evaluations);
    rmse.low = 1 / (rmse.high * rmse.high * evaluations);
    rmse.high = high;
    return rmse;
}

/// Of ln RMSE, from trial to trial; 0 for a deterministic method.
double log_variance(const ClassError& error) {
    const double relative = error.mean_square_se / (2 * error.rmse * error.rmse);
    return relative * relative;
}

}  // namespace

std::optional<ClassError> class_error(const CellEstimates& estimates, const Scene& scene, const Eigen::MatrixXd& exact,
                                      PairClass pair_class, VarianceStatus variance, double level) {
    ClassError error;
    error.pair_class = pair_class;
    error.trials = estimates.trials();
    std::vector<double> squares(error.trials, 0.0);  // by trial, summed over pairs
    for (const Quantity pair : distinct_pairs(estimates.faces, Completion::direct)) {
        if (ff::pair_class(scene, pair.from - 1, pair.to - 1) != pair_class) continue;
        ++error.pairs;
        const double truth = exact(pair.from - 1, pair.to - 1);
        const auto& values = estimates.values(pair);
        for (std::size_t trial = 0; trial < values.size(); ++trial) {
            squares[trial] += (values[trial] - truth) * (values[trial] - truth);
        }
    }
    if (error.pairs == 0 || error.trials == 0) return std::nullopt;
    for (double& square : squares) square /= static_cast<double>(error.pairs);

    const auto moments = stats::moments_of(squares, 0.0);
    error.rmse = std::sqrt(*moments.mean());
    if (variance != VarianceStatus::finite || error.rmse == 0) return error;
    error.mean_square_se = moments.standard_error().value_or(0.0);
    const auto evaluations = static_cast<double>(estimates.evaluations_per_face);
    error.efficiency = 1 / (*moments.mean() * evaluations);
    auto interval = stats::mean_interval_t(moments, level);
    if (!interval || interval->low <= 0) return error;
    error.interval = stats::square_root(*interval);
    error.efficiency_interval = efficiency_interval(*error.interval, evaluations);
    return error;
}

std::optional<stats::Interval> rmse_ratio_interval(const ClassError& first, const ClassError& second, double level) {
    std::size_t trials = std::numeric_limits<std::size_t>::max();
    for (const ClassError* error : {&first, &second}) {
        if (error->interval) trials = std::min(trials, error->trials);
    }
    if (trials == std::numeric_limits<std::size_t>::max()) return std::nullopt;
    const double ratio = second.rmse / first.rmse;
    const double reach = stats::student_critical(static_cast<double>(trials - 1), (1 - level) / 2) *
                         std::sqrt(log_variance(first) + log_variance(second));
    return stats::Interval{ratio * std::exp(-reach), ratio * std::exp(reach), level, "student_t_of_logarithm", trials};
}

}  // namespace ff::studies
