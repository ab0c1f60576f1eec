#include "stats/basics/quantiles.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/binomial.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ff::stats {

std::vector<double> sorted(std::span<const double> values) {
    std::vector<double> ascending(values.begin(), values.end());
    std::sort(ascending.begin(), ascending.end());
    return ascending;
}

std::vector<double> largest(std::span<const double> values, std::size_t count) {
    FF_EXPECT(count <= values.size());
    std::vector<double> all(values.begin(), values.end());
    const auto first = all.end() - static_cast<std::ptrdiff_t>(count);
    if (count > 0) std::nth_element(all.begin(), first, all.end());
    std::sort(first, all.end());
    return {first, all.end()};
}

double median(std::span<const double> values) {
    FF_EXPECT(!values.empty());
    std::vector<double> all(values.begin(), values.end());
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    if (all.size() % 2 == 1) return *middle;
    return quantile(std::array{*std::max_element(all.begin(), middle), *middle}, 0.5);
}

double quantile(std::span<const double> ascending, double probability) {
    FF_EXPECT(!ascending.empty() && 0 <= probability && probability <= 1);
    const double position = probability * static_cast<double>(ascending.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const std::size_t above = std::min(below + 1, ascending.size() - 1);
    return ascending[below] + (position - static_cast<double>(below)) * (ascending[above] - ascending[below]);
}

std::vector<double> quantiles(std::span<const double> values, std::span<const double> probabilities) {
    const std::vector<double> ascending = sorted(values);
    std::vector<double> result;
    result.reserve(probabilities.size());
    for (const double probability : probabilities) result.push_back(quantile(ascending, probability));
    return result;
}

std::optional<double> median_absolute_error(std::span<const double> values, double reference) {
    if (values.empty()) return std::nullopt;
    std::vector<double> errors(values.begin(), values.end());
    for (double& error : errors) error = std::abs(error - reference);
    return median(errors);
}

std::optional<CentralRange> central_range(std::span<const double> values, double share) {
    FF_EXPECT(0 < share && share < 1);
    if (values.empty()) return std::nullopt;
    const std::vector<double> ascending = sorted(values);
    return CentralRange{.low = quantile(ascending, (1 - share) / 2), .high = quantile(ascending, (1 + share) / 2)};
}

std::optional<Rank> rank_among(std::span<const double> values, double value, double level, double tolerance) {
    if (values.empty()) return std::nullopt;
    Rank rank;
    rank.n = values.size();
    for (const double other : values) {
        if (std::abs(other - value) <= tolerance) {
            ++rank.equal;
        } else if (other < value) {
            ++rank.below;
        }
    }
    const std::size_t upto = rank.below + rank.equal;
    const std::size_t from = rank.n - rank.below;
    const double n = static_cast<double>(rank.n);
    rank.percentile = (static_cast<double>(rank.below) + static_cast<double>(rank.equal) / 2) / n;
    rank.interval = clopper_pearson_interval({rank.below, rank.n}, level);
    rank.interval.high = clopper_pearson_interval({upto, rank.n}, level).high;
    rank.p = std::min(1.0, 2 * (static_cast<double>(std::min(upto, from)) + 1) / (n + 1));
    return rank;
}

}  // namespace ff::stats
