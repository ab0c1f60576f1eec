#include "stats/variances/spread.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"

#include <algorithm>
#include <cmath>

namespace ff::stats {
namespace {

constexpr std::size_t fewest_with_kurtosis = 4;

double effective_freedom(double freedom, double excess_kurtosis) {
    return freedom / (1 + std::max(0.0, excess_kurtosis) / 2);
}

}  // namespace

std::optional<MeanSquare> mean_square_of(const Moments& moments) {
    const auto excess = moments.excess_kurtosis();
    if (!excess) return std::nullopt;
    return MeanSquare{.mean_square = *moments.variance(),
                      .freedom = effective_freedom(static_cast<double>(moments.count() - 1), *excess),
                      .n = moments.count()};
}

std::optional<MeanSquare> mean_square_about(std::span<const double> values, double reference) {
    const auto n = static_cast<double>(values.size());
    double sum2 = 0;
    double sum4 = 0;
    double scale = 0;
    for (const double value : values) scale = std::max(scale, std::abs(value - reference));
    if (values.size() < fewest_with_kurtosis || scale == 0) return std::nullopt;
    for (const double value : values) {
        const double square = (value - reference) / scale * ((value - reference) / scale);
        sum2 += square;
        sum4 += square * square;
    }
    // (n + 2) / n: unbiased for normal errors.
    const double excess = n * sum4 / (sum2 * sum2) * (n + 2) / n - 3;
    return MeanSquare{
        .mean_square = sum2 / n * scale * scale, .freedom = effective_freedom(n, excess), .n = values.size()};
}

Interval mean_square_interval(const MeanSquare& spread, double level) {
    FF_EXPECT(0 < level && level < 1);
    const double tail = (1 - level) / 2;
    const double sum = spread.mean_square * spread.freedom;
    return {.low = sum / chi_squared_critical(spread.freedom, tail),
            .high = sum / chi_squared_critical(spread.freedom, 1 - tail),
            .level = level,
            .method = "adjusted_chi_squared",
            .n = spread.n};
}

Interval ratio_interval(const MeanSquare& a, const MeanSquare& b, double level) {
    FF_EXPECT(0 < level && level < 1);
    const double tail = (1 - level) / 2;
    const double ratio = a.mean_square / b.mean_square;
    return {.low = std::sqrt(ratio / fisher_critical(tail, a.freedom, b.freedom)),
            .high = std::sqrt(ratio / fisher_critical(1 - tail, a.freedom, b.freedom)),
            .level = level,
            .method = "adjusted_f",
            .n = std::min(a.n, b.n)};
}

}  // namespace ff::stats
