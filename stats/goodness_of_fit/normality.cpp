#include "stats/goodness_of_fit/normality.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"
#include "stats/basics/moments.hpp"
#include "stats/basics/quantiles.hpp"
#include "stats/basics/resampling.hpp"

#include <algorithm>
#include <cmath>

namespace ff::stats {
namespace {

/// ln P(Z < z), finite far below the point where P itself underflows (Mills' ratio there).
double log_normal_cdf(double z) {
    constexpr double far = -35;
    if (z > far) return std::log(normal_tail(-z));
    constexpr double half_log_two_pi = 0.91893853320467274178;
    return -z * z / 2 - half_log_two_pi - std::log(-z) - 1 / (z * z);
}

/// Stephens' fit to the distribution of the adjusted A^2 [stephens1986], table 4.9. Its last branch turns upward far
/// out, so it is held at its value for 10.
double stephens_p(double a) {
    if (a < 0.2) return 1 - std::exp(-13.436 + 101.14 * a - 223.73 * a * a);
    if (a < 0.34) return 1 - std::exp(-8.318 + 42.796 * a - 59.938 * a * a);
    if (a < 0.6) return std::exp(0.9177 - 4.279 * a - 1.38 * a * a);
    a = std::min(a, 10.0);
    return std::exp(1.2937 - 5.709 * a + 0.0186 * a * a);
}

}  // namespace

std::optional<NormalityTest> test_normality(std::span<const double> values) {
    constexpr std::size_t fewest = 8;
    if (values.size() < fewest) return std::nullopt;
    const Moments moments = moments_of(values, values.front());
    const double sd = *moments.standard_deviation();
    if (sd == 0) return std::nullopt;

    const std::vector<double> ascending = sorted(values);
    const double n = static_cast<double>(ascending.size());
    double sum = 0;
    for (std::size_t i = 0; i < ascending.size(); ++i) {
        const double low = (ascending[i] - *moments.mean()) / sd;
        const double high = (ascending[ascending.size() - 1 - i] - *moments.mean()) / sd;
        sum += (2 * static_cast<double>(i) + 1) * (log_normal_cdf(low) + log_normal_cdf(-high));
    }
    NormalityTest test;
    test.statistic = -n - sum / n;
    test.adjusted = test.statistic * (1 + 0.75 / n + 2.25 / (n * n));
    test.p = stephens_p(test.adjusted);
    return test;
}

std::vector<double> jitter_lattice(std::span<const double> values, double spacing, StreamKey key) {
    FF_EXPECT(spacing > 0);
    Draws draws(key, Resampling::jitter, 0);
    std::vector<double> jittered(values.begin(), values.end());
    for (double& value : jittered) value += (draws.uniform() - 0.5) * spacing;
    return jittered;
}

}  // namespace ff::stats
