#include "stats/variances/tail_doubt.hpp"

#include "stats/basics/moments.hpp"
#include "stats/basics/quantiles.hpp"
#include "stats/variances/tail_index.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ff::stats {
namespace {

constexpr std::size_t fewest_values = 50;  // below, a normal sample may look like anything
constexpr double tail_alpha = 0.005;       // of each tail
constexpr double largest_vov = 0.1;        // of a healthy mean [pederson1997]
constexpr double largest_vov_of_few = 10;  // over n: that of an exponential distribution is 8 / n
constexpr double largest_shape = 2.0 / 3;  // of the outer tenth about the median: an index of 3/2
constexpr std::size_t fewest_of_the_tail = 10;
constexpr std::size_t enough_values = 1000;  // to show that a tail as light as the exponential one has a variance
constexpr std::size_t enough_pooled = 500;   // for a tail as light as the normal one
constexpr double light_alpha = 0.05;         // of calling a variance finite that is not

/// Index of both tails together by Hill's estimate about the median; empty where too many values are equal to it.
std::optional<double> outer_index(std::span<const double> values) {
    const double median = quantile(sorted(values), 0.5);
    std::vector<double> distances(values.begin(), values.end());
    for (double& distance : distances) distance = std::abs(distance - median);
    const auto tail = fit_tail_hill(distances, std::max(fewest_of_the_tail, values.size() / 10));
    return tail && tail->shape > largest_shape ? tail->index : std::nullopt;
}

/// Judges by the tail index of either side; from `enough` values on, both have to be shown to be above 2.
std::optional<TailDoubt> doubt_indices(std::span<const double> values, std::size_t enough) {
    using enum TailDoubt::Reason;
    std::vector<double> side(values.begin(), values.end());
    for (int turn = 0; turn < 2; ++turn) {
        if (const auto tail = fit_tail(side)) {
            if (judge_variance(*tail, tail_alpha) == VarianceHealth::infinite)
                return TailDoubt{infinite_variance, *tail->index, 2};
            const bool light = judge_variance(*tail, light_alpha) == VarianceHealth::finite;
            if (values.size() >= enough && !light) return TailDoubt{not_shown_finite, 0, 2};
        }
        for (double& value : side) value = -value;
    }
    return std::nullopt;
}

}  // namespace

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
    const double median = quantile(ascending, 0.5);
    for (const double value : ascending) values_.push_back((value - median) / spread);
}

std::optional<TailDoubt> PooledTails::doubt() const {
    return values_.size() < enough_pooled ? std::nullopt : doubt_indices(values_, enough_pooled);
}

}  // namespace ff::stats
