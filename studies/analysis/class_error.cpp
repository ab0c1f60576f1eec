#include "studies/analysis/class_error.hpp"

#include "core/visibility/facing.hpp"
#include "stats/basics/moments.hpp"
#include "stats/basics/quantiles.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace ff::studies {
namespace {

/// Mean over the pairs of each trial.
std::vector<double> trial_means(std::span<const double> values, std::size_t pairs) {
    std::vector<double> means(values.size() / pairs, 0.0);
    for (std::size_t i = 0; i < values.size(); ++i) means[i / pairs] += values[i];
    for (double& mean : means) mean /= static_cast<double>(pairs);
    return means;
}

/// Squared deviations from `centres`, one for each pair.
std::vector<double> squared_deviations(std::span<const double> errors, const std::vector<double>& centres) {
    std::vector<double> squares;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const double deviation = errors[i] - centres[i % centres.size()];
        squares.push_back(deviation * deviation);
    }
    return squares;
}

/// Mean over trials of each pair.
std::vector<double> pair_means(std::span<const double> errors, std::size_t pairs) {
    const std::size_t trials = errors.size() / pairs;
    std::vector<double> means(pairs, 0.0);
    for (std::size_t i = 0; i < errors.size(); ++i) means[i % pairs] += errors[i] / static_cast<double>(trials);
    return means;
}

/// Interval for a mean of squares. Values that no evaluation has met can only raise the mean, so that the lower end
/// does not allow for them. Empty where an end would be 0 or infinite.
std::optional<stats::Interval> positive_interval(const stats::MeanEvidence& mean, double level) {
    auto interval = stats::interval_of(mean, level);
    stats::MeanEvidence met = mean;
    met.unmet = {};
    interval.low = stats::interval_of(met, level).low;
    return interval.low > 0 && interval.is_finite() ? std::optional(interval) : std::nullopt;
}

/// The mean over trials of mean squares over some pairs. Squares of skewed errors have a tail so long that dozens of
/// them may all lie below their mean: a mean of fewer than a hundred may have to be larger by the share that is missing
/// (chosen by simulation; docs/statistics.md).
std::optional<stats::MeanEvidence> mean_of_squares(std::span<const double> squares, std::size_t pairs,
                                                   const stats::Unmet& unmet) {
    constexpr double enough = 100;
    auto mean = stats::mean_evidence(squares, 0);
    if (!mean) return std::nullopt;
    mean->unmet = unmet;
    mean->unseen = mean->difference * std::max(0.0, enough / static_cast<double>(squares.size() * pairs) - 1);
    return mean;
}

void add_variance(std::span<const double> errors, double level, const stats::Unmet& unmet, ClassError& found) {
    const auto deviations = trial_means(squared_deviations(errors, pair_means(errors, found.pairs)), found.pairs);
    const auto squares = stats::moments_of(deviations);
    const auto trials = static_cast<double>(found.trials);
    if (trials < 2 || *squares.mean() <= 0) return;
    const double unbiased = trials / (trials - 1);
    found.variance = *squares.mean() * unbiased;
    if (found.trials < stats::fewest_replicates) return;
    found.squared_deviation = mean_of_squares(deviations, found.pairs, unmet);
    if (!found.squared_deviation) return;
    found.variance_interval = positive_interval(*found.squared_deviation, level);
    if (!found.variance_interval) return;
    found.variance_interval->low *= unbiased;
    found.variance_interval->high *= unbiased;
}

/// Interval of 1 / (x N) from that of sqrt(x): the ends change places.
stats::Interval efficiency_interval(stats::Interval rmse, double evaluations) {
    const double high = 1 / (rmse.low * rmse.low * evaluations);
    rmse.low = 1 / (rmse.high * rmse.high * evaluations);
    rmse.high = high;
    return rmse;
}

/// @param squares  of the errors, about the exact values
void add_efficiency(std::span<const double> squares, double level, const stats::Unmet& unmet, ClassError& found) {
    if (found.rmse == 0) return;
    const auto evaluations = static_cast<double>(found.evaluations);
    found.efficiency = 1 / (found.rmse * found.rmse * evaluations);
    if (squares.size() < stats::fewest_replicates) return;
    found.mean_square = mean_of_squares(squares, found.pairs, unmet);
    if (!found.mean_square) return;
    const auto interval = positive_interval(*found.mean_square, level);
    if (!interval) return;
    found.interval = stats::square_root(*interval);
    found.efficiency_interval = efficiency_interval(*found.interval, evaluations);
}

}  // namespace

stats::Unmet unmet_squares(const std::vector<stats::Unmet>& pairs, std::uint64_t samples_of_pair) {
    stats::Unmet mean;
    for (const stats::Unmet& pair : pairs) {
        if (pair.largest == 0 || !std::isfinite(pair.largest)) continue;
        mean.largest += pair.largest * pair.largest / static_cast<double>(samples_of_pair * pairs.size());
        mean.evaluations = pair.evaluations;
    }
    return mean;
}

std::optional<ClassError> class_error(const CellEstimates& estimates, const Scene& scene, const KnownFactors& known,
                                      std::span<const Quantity> pairs, PairClass pair_class, VarianceStatus status,
                                      double level, const UnmetOf& unmet_of) {
    const auto members = pairs_of_class(scene, known_pairs(pairs, known), pair_class);
    const auto errors = errors_of(estimates, members, known);
    if (errors.empty()) return std::nullopt;
    std::vector<stats::Unmet> unmet;
    for (const Quantity pair : members) unmet.push_back(unmet_of(pair));
    ClassError found = class_error_of(errors, members.size(), estimates.evaluations_per_face, status, level,
                                      unmet_squares(unmet, estimates.samples_of_pair));
    found.pair_class = pair_class;
    return found;
}

ClassError class_error_of(std::span<const double> errors, std::size_t pairs, std::uint64_t evaluations,
                          VarianceStatus status, double level, const stats::Unmet& unmet) {
    ClassError found;
    found.pairs = pairs;
    found.trials = errors.size() / pairs;
    found.evaluations = evaluations;
    found.status = status;
    const std::vector<double> exactly(found.pairs, 0.0);
    const auto squares = trial_means(squared_deviations(errors, exactly), found.pairs);
    const auto means = trial_means(errors, found.pairs);
    found.rmse = std::sqrt(*stats::moments_of(squares).mean());
    found.median_abs_error = *stats::median_absolute_error(errors, 0);
    found.bias = *stats::moments_of(means).mean();
    // Too few hits do not allow a test of a mean, but their spread can be measured.
    if (status == VarianceStatus::finite || status == VarianceStatus::sparse) add_variance(errors, level, unmet, found);
    if (status != VarianceStatus::finite) return found;
    found.bias_interval = stats::mean_interval(means, 0, level);
    add_efficiency(squares, level, unmet, found);
    return found;
}

std::vector<double> errors_of(const CellEstimates& estimates, std::span<const Quantity> pairs,
                              const KnownFactors& known) {
    std::vector<double> errors;
    errors.reserve(estimates.trials() * pairs.size());
    for (std::size_t trial = 0; trial < estimates.trials(); ++trial) {
        for (const Quantity pair : pairs)
            errors.push_back(estimates.values(pair)[trial] - known.at(pair.from - 1, pair.to - 1).value());
    }
    return errors;
}

std::vector<Quantity> known_pairs(std::span<const Quantity> pairs, const KnownFactors& known) {
    std::vector<Quantity> members;
    std::ranges::copy_if(pairs, std::back_inserter(members),
                         [&](const Quantity pair) { return known.at(pair.from - 1, pair.to - 1).has_value(); });
    return members;
}

std::vector<Quantity> pairs_of_class(const Scene& scene, std::span<const Quantity> pairs, PairClass wanted) {
    std::vector<Quantity> members;
    std::ranges::copy_if(pairs, std::back_inserter(members), [&](const Quantity pair) {
        return face_each_other(scene, pair.from - 1, pair.to - 1) &&
               pair_class(scene, pair.from - 1, pair.to - 1) == wanted;
    });
    return members;
}

std::vector<Quantity> known_pairs_of_class(const StudyPlan& plan, const Cell& cell, const KnownFactors& known,
                                           PairClass wanted) {
    const Scene& scene = plan.scenes[cell.scene];
    const auto pairs = distinct_pairs(plan.scenes.faces(cell.scene).size(), plan.spec.methods[cell.method].completion);
    return pairs_of_class(scene, known_pairs(pairs, known), wanted);
}

std::optional<stats::Measured> log_rmse(const ClassError& error, bool certain) {
    if (certain) return stats::Measured{std::log(error.rmse), {}};
    if (!error.mean_square) return std::nullopt;
    stats::Measured logarithm = stats::logarithm_of(*error.mean_square);
    logarithm.value /= 2;
    logarithm.parts.front().weight = 0.5;
    return logarithm;
}

stats::Measured log_variance(const ClassError& error) {
    return stats::logarithm_of(*error.squared_deviation, *error.variance / error.squared_deviation->difference);
}

std::optional<stats::Interval> ratio_interval(const stats::Measured& first, const stats::Measured& second, double level,
                                              double correlation) {
    auto interval = stats::difference_interval(first, second, level, correlation);
    if (!interval) return std::nullopt;
    interval->low = std::exp(interval->low);
    interval->high = std::exp(interval->high);
    return interval;
}

}  // namespace ff::studies
