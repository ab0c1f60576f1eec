#include "tests/unit/samplers/nets/scrambling.hpp"

#include "stats/variances/variance_interval.hpp"
#include "tests/support/statistical_assertions.hpp"

#include <cmath>

namespace ff::test {
namespace {

constexpr std::uint32_t scrambling_replicates = 1000;
constexpr double scrambling_alpha = 1e-6;

}  // namespace

std::vector<Integral> scrambling_integrals() {
    return {
        {"SmoothProduct", 1, [](double x, double y, double z, double w) { return 16 * x * y * z * w; }},
        {"Exponential", std::pow(std::exp(1.0) - 1, 4),
         [](double x, double y, double z, double w) { return std::exp(x + y + z + w); }},
        {"HalfSpace", 0.5, [](double x, double y, double z, double w) { return x + y + z + w < 2 ? 1.0 : 0.0; }},
        // python3 -c "from math import pi; print(pi**2 / 32)", the positive part of the 4-D unit ball
        {"Ball", 0.30842513753404244,
         [](double x, double y, double z, double w) { return x * x + y * y + z * z + w * w < 1 ? 1.0 : 0.0; }},
    };
}

std::vector<double> scrambled_estimates(Fill fill, const Integral& integral, std::size_t points) {
    std::vector<double> result;
    PointBlock block;
    block.size = points;
    for (std::uint32_t trial = 0; trial < scrambling_replicates; ++trial) {
        fill({.key = {20261120, 1}, .trial = trial}, block);
        double sum = 0;
        for (std::size_t i = 0; i < points; ++i) {
            const auto x = [&](std::size_t d) { return (block.coordinate[d][i] + 0.5) * 0x1p-32; };
            sum += integral.integrand(x(0), x(1), x(2), x(3));
        }
        result.push_back(sum / static_cast<double>(points));
    }
    return result;
}

testing::AssertionResult has_mean(const std::vector<double>& estimates, const Integral& integral) {
    return unbiased(estimates, integral.value, {.alpha = scrambling_alpha, .detects = 0.01 * integral.value});
}

bool have_same_variance(const std::vector<double>& a, const std::vector<double>& b) {
    const auto spread = [](const std::vector<double>& values) {
        return stats::mean_square_of(stats::moments_of(values, values.front())).value();
    };
    const stats::Interval ratio = stats::ratio_interval(spread(a), spread(b), 1 - scrambling_alpha);
    return ratio.low < 1 && 1 < ratio.high;
}

}  // namespace ff::test
