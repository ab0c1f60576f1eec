#include "stats/variances/tail_index.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"
#include "stats/basics/quantiles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ff::stats {
namespace {

constexpr double critical_shape = 0.5;  // index 2

TailFit with_shape(double shape, double threshold, std::size_t exceedances) {
    TailFit fit;
    fit.shape = shape;
    fit.exceedances = exceedances;
    fit.threshold = threshold;
    if (shape > 0) fit.index = 1 / shape;
    return fit;
}

double mean_log1p(std::span<const double> excesses, double factor) {
    double sum = 0;
    for (const double excess : excesses) sum += std::log1p(factor * excess);
    return sum / static_cast<double>(excesses.size());
}

/// Shape of the generalised Pareto law of ascending excesses: the mean of the profile likelihood over a grid that the
/// data choose, nearly as efficient as maximum likelihood and always defined. @see [zhang2009]
double pareto_shape(std::span<const double> excesses) {
    const double n = static_cast<double>(excesses.size());
    const double quartile = excesses[(excesses.size() + 2) / 4 - 1];
    const auto points = 20 + static_cast<std::size_t>(std::sqrt(n));

    std::vector<double> rates;
    std::vector<double> likelihoods;
    double best = -std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < points; ++j) {
        const double rate =
            1 / excesses.back() +
            (1 - std::sqrt(static_cast<double>(points) / (static_cast<double>(j) + 0.5))) / (3 * quartile);
        const double shape = mean_log1p(excesses, -rate);
        rates.push_back(rate);
        likelihoods.push_back(n * (std::log(-rate / shape) - shape - 1));
        best = std::max(best, likelihoods.back());
    }
    double total = 0;
    double rate = 0;
    for (std::size_t j = 0; j < rates.size(); ++j) {
        const double weight = std::exp(likelihoods[j] - best);
        total += weight;
        rate += weight * rates[j];
    }
    return mean_log1p(excesses, -rate / total);
}

}  // namespace

std::optional<TailFit> fit_tail(std::span<const double> values, double fraction) {
    FF_EXPECT(0 < fraction && fraction < 1);
    constexpr std::size_t fewest_exceedances = 20;
    const auto exceedances = static_cast<std::size_t>(fraction * static_cast<double>(values.size()));
    if (exceedances < fewest_exceedances) return std::nullopt;

    const std::vector<double> ascending = sorted(values);
    const std::size_t first = ascending.size() - exceedances;
    const double threshold = ascending[first - 1];
    std::vector<double> excesses(ascending.begin() + static_cast<std::ptrdiff_t>(first), ascending.end());
    for (double& excess : excesses) excess -= threshold;
    // Ties at the threshold: too discrete to say.
    if (excesses[exceedances / 4 - 1] <= 0) return std::nullopt;
    TailFit fit = with_shape(pareto_shape(excesses), threshold, exceedances);
    const double root = std::sqrt(static_cast<double>(exceedances));
    // The asymptotic error holds for shapes above -1/2 and keeps its value there for the lightest tails.
    fit.standard_error = (1 + std::max(fit.shape, -0.5)) / root;
    fit.error_at_two = (1 + critical_shape) / root;
    return fit;
}

std::optional<TailFit> fit_tail_hill(std::span<const double> values, std::size_t exceedances) {
    FF_EXPECT(exceedances >= 2);
    if (values.size() <= exceedances) return std::nullopt;
    const std::vector<double> ascending = sorted(values);
    const std::size_t first = ascending.size() - exceedances;
    const double threshold = ascending[first - 1];
    if (threshold <= 0 || threshold == ascending.back()) return std::nullopt;
    double sum = 0;
    for (std::size_t i = first; i < ascending.size(); ++i) sum += std::log(ascending[i] / threshold);
    const double count = static_cast<double>(exceedances);
    TailFit fit = with_shape(sum / count, threshold, exceedances);
    fit.standard_error = fit.shape / std::sqrt(count);
    fit.error_at_two = critical_shape / std::sqrt(count);
    return fit;
}

VarianceHealth judge_variance(const TailFit& fit, double alpha) {
    const double significant = normal_critical(alpha) * fit.error_at_two;
    if (fit.shape > critical_shape + significant) return VarianceHealth::infinite;
    if (fit.shape < critical_shape - significant) return VarianceHealth::finite;
    return VarianceHealth::undecided;
}

}  // namespace ff::stats
