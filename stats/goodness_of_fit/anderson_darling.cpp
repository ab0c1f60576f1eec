#include "stats/goodness_of_fit/anderson_darling.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"
#include "stats/basics/moments.hpp"
#include "stats/basics/quantiles.hpp"
#include "stats/basics/resampling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ff::stats {
namespace {

constexpr double pi = std::numbers::pi;

/// Calls `visit(above, below, values, times)` at each distinct value of both samples together but the last: how many of
/// each are at most as large, and how often it occurs.
template <class Visit>
void walk(std::span<const double> first, std::span<const double> second, const Visit& visit) {
    std::size_t a = 0;
    std::size_t b = 0;
    while (a < first.size() || b < second.size()) {
        const std::size_t before = a + b;
        const double value = b == second.size() || (a < first.size() && first[a] <= second[b]) ? first[a] : second[b];
        while (a < first.size() && first[a] == value) ++a;
        while (b < second.size() && second[b] == value) ++b;
        if (a + b < first.size() + second.size()) visit(a, b, a + b - before);
    }
}

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

/// P(Q > z) for Q = sum of squares / (j (j + 1)): an alternating sum of integrals between the poles j (j + 1), whose
/// ends are taken care of by Chebyshev's nodes.
double anderson_darling_tail(double z) {
    constexpr int nodes = 64;
    constexpr int terms = 8;
    constexpr double bulk = 0.3;  // below, the sum needs more terms than it is worth
    if (!(z > bulk)) return 1;
    double sum = 0;
    for (int k = 1; k <= terms; ++k) {
        const double low = (2.0 * k - 1) * (2.0 * k);
        const double high = 2.0 * k * (2.0 * k + 1);
        double part = 0;
        for (int i = 0; i < nodes; ++i) {
            const double y = (low + high) / 2 + (high - low) / 2 * std::cos((i + 0.5) / nodes * pi);
            const double product = std::abs(std::cos(pi / 2 * std::sqrt(1 + 4 * y)) / (pi * y));
            part += std::exp(-y * z / 2) / y * std::sqrt((y - low) * (high - y) / product);
        }
        sum += (k % 2 == 1 ? part : -part) / nodes;
    }
    return std::clamp(sum, 0.0, 1.0);
}

double anderson_darling(std::span<const double> uniform, double tolerance) {
    FF_EXPECT(!uniform.empty() && tolerance >= 0);
    const auto n = static_cast<double>(uniform.size());
    double sum = 0;
    for (std::size_t i = 0; i < uniform.size(); ++i) {
        const double share = (2 * static_cast<double>(i) + 1) / (2 * n);  // the value at which the term is least
        const double v =
            std::clamp(share, std::max(0.0, uniform[i] - tolerance), std::min(1.0, uniform[i] + tolerance));
        if (v <= 0 || v >= 1) return std::numeric_limits<double>::infinity();
        sum += 2 * n * (share * std::log(v) + (1 - share) * std::log1p(-v));
    }
    return -n - sum / n;
}

double anderson_darling(std::span<const double> first, std::span<const double> second, double tolerance) {
    FF_EXPECT(!first.empty() && !second.empty() && tolerance >= 0);
    const auto n = static_cast<double>(first.size());
    const auto m = static_cast<double>(second.size());
    double sum = 0;
    walk(first, second, [&](std::size_t a, std::size_t b, std::size_t times) {
        const double excess = std::abs(static_cast<double>(a) / n - static_cast<double>(b) / m) - tolerance;
        if (excess <= 0) return;
        const double together = static_cast<double>(a + b) / (n + m);
        const double h = std::clamp(0.5, together - tolerance, together + tolerance);
        sum += static_cast<double>(times) * excess * excess / (h * (1 - h));
    });
    return n * m / ((n + m) * (n + m)) * sum;
}

double kolmogorov_distance(std::span<const double> uniform) {
    FF_EXPECT(!uniform.empty());
    const auto n = static_cast<double>(uniform.size());
    double distance = 0;
    for (std::size_t i = 0; i < uniform.size(); ++i)
        distance =
            std::max({distance, uniform[i] - static_cast<double>(i) / n, static_cast<double>(i + 1) / n - uniform[i]});
    return distance;
}

double kolmogorov_distance(std::span<const double> first, std::span<const double> second) {
    FF_EXPECT(!first.empty() && !second.empty());
    double distance = 0;
    walk(first, second, [&](std::size_t a, std::size_t b, std::size_t) {
        distance = std::max(distance, std::abs(static_cast<double>(a) / static_cast<double>(first.size()) -
                                               static_cast<double>(b) / static_cast<double>(second.size())));
    });
    return distance;
}

double dkw_half_width(std::size_t n, double level) {
    FF_EXPECT(n >= 1 && 0 < level && level < 1);
    return std::sqrt(std::log(2 / (1 - level)) / (2 * static_cast<double>(n)));
}

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
