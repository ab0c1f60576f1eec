#include "studies/analysis/pair_spreads.hpp"

#include "stats/basics/distributions.hpp"
#include "stats/basics/quantiles.hpp"
#include "studies/theory/known_variance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ff::studies {
namespace {

double relative_error(const stats::Measured& logarithm) {
    const stats::MeanEvidence& mean = logarithm.parts.front().mean;
    return mean.standard_error / mean.difference;
}

std::optional<stats::Measured> log_variance_of(const StudyPlan& plan, const CellEstimates& estimates, Quantity pair) {
    std::vector<double> values = estimates.values(pair);
    const double first = values.front();  // trials that do not vary have deviations of exactly 0 from it
    for (double& value : values) value -= first;
    ClassError found =
        class_error_of(values, 1, estimates.evaluations_per_face, VarianceStatus::finite, plan.spec.level,
                       unmet_squares({known_limits(plan, estimates, pair).unmet}, estimates.samples_of_pair));
    if (!found.squared_deviation) return std::nullopt;
    found.squared_deviation->unseen = 0;  // the other pairs of the cell say how skewed few trials may be
    return log_variance(found);
}

}  // namespace

PairSpreads spreads_of(std::vector<std::optional<stats::Measured>> logarithms) {
    std::vector<double> skewness;
    for (const auto& logarithm : logarithms) {
        if (logarithm) skewness.push_back(logarithm->parts.front().mean.skewness.value);
    }
    return {std::move(logarithms), skewness.empty() ? 0 : stats::quantile(stats::sorted(skewness), 0.5)};
}

PairSpreads spreads_of(const StudyPlan& plan, const CellAnalysis& found, const CellEstimates& estimates,
                       std::span<const Quantity> pairs) {
    std::vector<std::optional<stats::Measured>> logarithms;
    for (const Quantity pair : pairs) {
        const bool finite = found.summary(pair).variance == VarianceStatus::finite;
        logarithms.push_back(finite ? log_variance_of(plan, estimates, pair) : std::nullopt);
    }
    return spreads_of(std::move(logarithms));
}

std::optional<std::array<stats::Measured, 2>> compared_spreads(const PairSpreads& first, const PairSpreads& second,
                                                               std::size_t pair) {
    if (!first.logarithms[pair] || !second.logarithms[pair]) return std::nullopt;
    std::array both{*first.logarithms[pair], *second.logarithms[pair]};
    const bool first_is_smaller = both[0].value < both[1].value;
    double& skewness = both[first_is_smaller ? 0 : 1].parts.front().mean.skewness.value;
    skewness = std::max(skewness, first_is_smaller ? first.skewness : second.skewness);
    return both;
}

double detectable_ratio(const std::array<stats::Measured, 2>& spreads, double level, double power) {
    const auto interval = *stats::difference_interval(spreads[0], spreads[1], level);
    const double difference = spreads[1].value - spreads[0].value;
    const double reach = std::max(difference - interval.low, interval.high - difference);
    const double error = std::hypot(relative_error(spreads[0]), relative_error(spreads[1]));
    return std::exp((reach + stats::normal_critical(1 - power) * error) / 2);
}

}  // namespace ff::studies
