#include "stats/variances/tails.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"
#include "stats/basics/moments.hpp"
#include "stats/basics/quantiles.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace ff::stats {
namespace {

constexpr double critical_shape = 0.5;  // index 2

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

constexpr std::size_t fewest_values = 50;  // below, a normal sample may look like anything
constexpr double tail_alpha = 0.005;       // level for each tail
constexpr double largest_vov = 0.1;        // relative variance of the variance of a healthy mean [pederson1997]
constexpr double largest_vov_of_few = 10;  // to be divided by n; an exponential distribution has 8 / n
constexpr double largest_shape = 2.0 / 3;  // shape of the outer tenth about the median: index 3/2
constexpr std::size_t fewest_of_the_tail = 10;
constexpr std::size_t enough_values = 1000;  // enough to show that a tail as light as exponential has a variance
constexpr std::size_t enough_pooled = 500;   // enough for a tail as light as normal
constexpr double light_alpha = 0.05;         // risk of calling an infinite variance finite

/// Index of both tails together by Hill's estimate about the median; empty where too many values are equal to it.
std::optional<double> outer_index(std::span<const double> values) {
    const double middle = median(values);
    std::vector<double> distances(values.begin(), values.end());
    for (double& distance : distances) distance = std::abs(distance - middle);
    const auto tail = fit_tail_hill(distances, std::max(fewest_of_the_tail, values.size() / 10));
    return tail && tail->shape > largest_shape ? tail->index() : std::nullopt;
}

/// Judges by the tail index of either side; from `enough` values on, both have to be shown to be above 2.
std::optional<TailDoubt> doubt_indices(std::span<const double> values, std::size_t enough) {
    using enum TailDoubt::Reason;
    std::vector<double> side(values.begin(), values.end());
    for (int turn = 0; turn < 2; ++turn) {
        if (const auto tail = fit_tail(side)) {
            if (judge_variance(*tail, tail_alpha) == VarianceHealth::infinite)
                return TailDoubt{infinite_variance, *tail->index(), 2};
            const bool light = judge_variance(*tail, light_alpha) == VarianceHealth::finite;
            if (values.size() >= enough && !light) return TailDoubt{not_shown_finite, 0, 2};
        }
        for (double& value : side) value = -value;
    }
    return std::nullopt;
}

}  // namespace

std::optional<TailFit> fit_tail(std::span<const double> values, double fraction) {
    FF_EXPECT(0 < fraction && fraction < 1);
    constexpr std::size_t fewest_exceedances = 20;
    const auto exceedances = static_cast<std::size_t>(fraction * static_cast<double>(values.size()));
    if (exceedances < fewest_exceedances) return std::nullopt;

    std::vector<double> excesses = largest(values, exceedances + 1);
    const double threshold = excesses.front();
    excesses.erase(excesses.begin());
    for (double& excess : excesses) excess -= threshold;
    // Ties at the threshold: too discrete to say.
    if (excesses[exceedances / 4 - 1] <= 0) return std::nullopt;
    const double shape = pareto_shape(excesses);
    const double root = std::sqrt(static_cast<double>(exceedances));
    // The asymptotic error holds for shapes above -1/2 and keeps its value there for the lightest tails.
    return TailFit{.shape = shape,
                   .standard_error = (1 + std::max(shape, -0.5)) / root,
                   .error_at_two = (1 + critical_shape) / root};
}

std::optional<TailFit> fit_tail_hill(std::span<const double> values, std::size_t exceedances) {
    FF_EXPECT(exceedances >= 2);
    if (values.size() <= exceedances) return std::nullopt;
    const std::vector<double> ascending = largest(values, exceedances + 1);
    const double threshold = ascending.front();
    if (threshold <= 0 || threshold == ascending.back()) return std::nullopt;
    double sum = 0;
    for (const double value : std::span(ascending).subspan(1)) sum += std::log(value / threshold);
    const double count = static_cast<double>(exceedances);
    const double shape = sum / count;
    return TailFit{
        .shape = shape, .standard_error = shape / std::sqrt(count), .error_at_two = critical_shape / std::sqrt(count)};
}

VarianceHealth judge_variance(const TailFit& fit, double alpha) {
    const double significant = normal_critical(alpha) * fit.error_at_two;
    if (fit.shape > critical_shape + significant) return VarianceHealth::infinite;
    if (fit.shape < critical_shape - significant) return VarianceHealth::finite;
    return VarianceHealth::undecided;
}

std::optional<TailDoubt> doubt_tails(std::span<const double> values) {
    using enum TailDoubt::Reason;
    if (values.size() < fewest_values) return std::nullopt;
    if (const auto doubt = doubt_indices(values, enough_values)) return doubt;
    const auto vov = moments_of(values, values.front()).variance_of_variance();
    const double largest = std::max(largest_vov, largest_vov_of_few / static_cast<double>(values.size()));
    if (vov && *vov > largest) return TailDoubt{few_values_decide, *vov, largest};
    if (const auto index = outer_index(values)) return TailDoubt{outer_tails_infinite, *index, 1 / largest_shape};
    return std::nullopt;
}

void PooledTails::add(std::span<const double> values) {
    if (values.empty()) return;
    const auto ascending = sorted(values);
    const double spread = quantile(ascending, 0.75) - quantile(ascending, 0.25);
    if (!(spread > 0)) return;
    const double middle = quantile(ascending, 0.5);
    for (const double value : ascending) values_.push_back((value - middle) / spread);
}

std::optional<TailDoubt> PooledTails::doubt() const {
    return values_.size() < enough_pooled ? std::nullopt : doubt_indices(values_, enough_pooled);
}

}  // namespace ff::stats
