#include "studies/class_errors.hpp"

#include "stats/distributions.hpp"
#include "stats/mean_interval.hpp"
#include "stats/moments.hpp"
#include "stats/quantiles.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace ff::studies {
namespace {

/// Mean over the pairs of each trial.
std::vector<double> trial_means(std::span<const double> values, std::size_t pairs) {
    std::vector<double> means(values.size() / pairs, 0.0);
    for (std::size_t i = 0; i < values.size(); ++i) means[i / pairs] += values[i] / static_cast<double>(pairs);
    return means;
}

/// Squared deviations from the mean of each pair.
std::vector<double> squared_deviations(std::span<const double> errors, std::size_t pairs) {
    const double trials = static_cast<double>(errors.size() / pairs);
    std::vector<double> means(pairs, 0.0);
    for (std::size_t i = 0; i < errors.size(); ++i) means[i % pairs] += errors[i] / trials;
    std::vector<double> squares;
    for (std::size_t i = 0; i < errors.size(); ++i)
        squares.push_back((errors[i] - means[i % pairs]) * (errors[i] - means[i % pairs]));
    return squares;
}

void add_variance(std::span<const double> errors, std::size_t pairs, double level, ClassErrors& found) {
    const auto squares = stats::moments_of(trial_means(squared_deviations(errors, pairs), pairs));
    const double trials = static_cast<double>(squares.count());
    if (trials < 2 || *squares.mean() <= 0) return;
    found.variance = *squares.mean() * trials / (trials - 1);
    const double relative_error = *squares.standard_error() / *squares.mean();
    const double factor = std::exp(stats::normal_critical((1 - level) / 2) * relative_error);
    found.variance_interval = stats::Interval{.low = *found.variance / factor,
                                              .high = *found.variance * factor,
                                              .level = level,
                                              .method = "log_normal",
                                              .n = squares.count()};
}

}  // namespace

ClassErrors summarise_class(std::span<const double> errors, std::size_t pairs, std::uint64_t evaluations,
                            VarianceStatus variance, double level) {
    ClassErrors found;
    found.evaluations = evaluations;
    if (errors.empty()) return found;
    found.median_abs_error = stats::median_absolute_error(errors, 0);
    const auto means = stats::moments_of(trial_means(errors, pairs));
    found.bias = means.mean();
    if (variance == VarianceStatus::infinite) return found;
    found.rmse = root_mean_square(errors);
    if (variance == VarianceStatus::none) return found;
    found.bias_interval = stats::mean_interval_t(means, level);
    add_variance(errors, pairs, level, found);
    if (!found.variance) return found;
    const double n = static_cast<double>(evaluations);
    found.efficiency = 1 / (*found.variance * n);
    found.efficiency_interval = stats::Interval{.low = 1 / (found.variance_interval->high * n),
                                                .high = 1 / (found.variance_interval->low * n),
                                                .level = level,
                                                .method = "log_normal",
                                                .n = found.variance_interval->n};
    return found;
}

std::vector<double> errors_of(const CellEstimates& estimates, std::span<const Quantity> pairs,
                              const Eigen::MatrixXd& exact) {
    std::vector<double> errors;
    errors.reserve(estimates.trials() * pairs.size());
    for (std::size_t trial = 0; trial < estimates.trials(); ++trial) {
        for (const Quantity pair : pairs)
            errors.push_back(estimates.values(pair)[trial] - exact(pair.from - 1, pair.to - 1));
    }
    return errors;
}

std::vector<Quantity> pairs_of_class(const Scene& scene, std::span<const Quantity> pairs, PairClass wanted) {
    std::vector<Quantity> members;
    std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(members),
                 [&](const Quantity pair) { return pair_class(scene, pair.from - 1, pair.to - 1) == wanted; });
    return members;
}

double root_mean_square(std::span<const double> errors) {
    double sum = 0;
    for (const double error : errors) sum += error * error;
    return std::sqrt(sum / static_cast<double>(errors.size()));
}

}  // namespace ff::studies
