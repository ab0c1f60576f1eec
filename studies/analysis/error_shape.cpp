#include "studies/analysis/error_shape.hpp"

#include "stats/basics/distributions.hpp"
#include "stats/basics/moments.hpp"
#include "stats/basics/quantiles.hpp"

#include <algorithm>
#include <cmath>

namespace ff::studies {
namespace {

constexpr std::size_t fewest_values = 20;
constexpr double fewest_bins = 8;
constexpr double most_bins = 40;
constexpr std::size_t most_quantiles = 41;

struct BinGrid {
    double low = 0;
    double width = 0;
    std::size_t bins = 0;
};

BinGrid grid_of(std::span<const double> ascending, double quartile_range, std::optional<double> lattice) {
    const double range = ascending.back() - ascending.front();
    const double rule = 2 * quartile_range / std::cbrt(static_cast<double>(ascending.size()));
    double width = std::clamp(rule, range / most_bins, range / fewest_bins);
    double low = ascending.front();
    if (lattice) {
        width = *lattice * std::max(1.0, std::round(width / *lattice));
        low -= *lattice / 2;
    }
    return {low, width, static_cast<std::size_t>(std::floor((ascending.back() - low) / width)) + 1};
}

}  // namespace

std::optional<ErrorShape> error_shape(std::span<const double> values, double reference, std::optional<double> lattice) {
    if (values.size() < fewest_values) return std::nullopt;
    std::vector<double> errors;
    for (const double value : values) errors.push_back(value - reference);
    std::sort(errors.begin(), errors.end());
    const auto moments = stats::moments_of(errors, 0.0);
    ErrorShape shape;
    shape.mean = *moments.mean();
    shape.sigma = *moments.standard_deviation();
    if (!(shape.sigma > 0)) return std::nullopt;
    shape.q25 = stats::quantile(errors, 0.25);
    shape.q75 = stats::quantile(errors, 0.75);

    const BinGrid grid = grid_of(errors, shape.q75 - shape.q25, lattice);
    const auto count = static_cast<double>(errors.size());
    const auto above = [&](double edge) { return count * stats::normal_tail((edge - shape.mean) / shape.sigma); };
    for (std::size_t i = 0; i < grid.bins; ++i) {
        const double low = grid.low + grid.width * static_cast<double>(i);
        const double high = grid.low + grid.width * static_cast<double>(i + 1);
        shape.bins.push_back({low, high, 0, above(low) - above(high)});
    }
    for (const double error : errors) {
        const auto bin = static_cast<std::size_t>(std::max(0.0, (error - grid.low) / grid.width));
        ++shape.bins[std::min(bin, grid.bins - 1)].runs;
    }

    const std::size_t quantiles = std::min(most_quantiles, errors.size());
    for (std::size_t k = 0; k < quantiles; ++k) {
        const double probability = (static_cast<double>(k) + 0.5) / static_cast<double>(quantiles);
        shape.quantiles.push_back({stats::normal_critical(1 - probability),
                                   (stats::quantile(errors, probability) - shape.mean) / shape.sigma});
    }
    return shape;
}

}  // namespace ff::studies
