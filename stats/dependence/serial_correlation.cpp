#include "stats/dependence/serial_correlation.hpp"

#include "core/points/stream.hpp"
#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"
#include "stats/basics/moments.hpp"
#include "stats/basics/resampling.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ff::stats {
namespace {

std::vector<double> centred(std::span<const double> values) {
    const double mean = *moments_of(values).mean();
    std::vector<double> result(values.begin(), values.end());
    for (double& value : result) value -= mean;
    return result;
}

double sum_of_products(const std::vector<double>& x, std::size_t lag) {
    double sum = 0;
    for (std::size_t i = lag; i < x.size(); ++i) sum += x[i] * x[i - lag];
    return sum;
}

/// Both statistics of a centred series, and the p-value that they would have if sums of products were normal.
SerialTest asymptotic_test(const std::vector<double>& x, double squares) {
    const auto n = static_cast<double>(x.size());
    SerialTest test;
    test.lags = std::min<std::size_t>(10, x.size() / 5);
    for (std::size_t k = 1; k <= test.lags; ++k) {
        const double r = sum_of_products(x, k) / squares;
        if (k == 1) test.first = r;
        test.statistic += n * (n + 2) * r * r / (n - static_cast<double>(k));
    }
    // Independent values have mean -1/n and variance (n - 2)^2 / (n^2 (n - 1)) at lag 1 [moran1948].
    const double z = (test.first + 1 / n) * n * std::sqrt(n - 1) / (n - 2);
    const double any = chi_squared_tail(test.statistic, static_cast<double>(test.lags));
    test.p = std::min(1.0, 2 * std::min(normal_tail(z), any));
    return test;
}

/// The share of random orders of a series that look as dependent as it does; 0 where none of many does.
double share_of_orders(std::vector<double> x, double squares, double p) {
    constexpr std::size_t enough = 20;  // such orders, to know their share
    const std::size_t cost = x.size() * std::min<std::size_t>(10, x.size() / 5);
    const std::size_t most = std::clamp<std::size_t>(20'000'000 / cost, 2000, 100'000);
    Draws draws(derive_key(Seed{1}, "serial correlation"), Resampling::simulation, 0);
    std::size_t found = 0;
    std::size_t orders = 0;
    while (found < enough && orders < most) {
        for (std::size_t i = x.size(); i > 1; --i) std::swap(x[i - 1], x[draws.below(i)]);
        ++orders;
        if (asymptotic_test(x, squares).p <= p) ++found;
    }
    return static_cast<double>(found) / static_cast<double>(orders);
}

}  // namespace

std::optional<SerialTest> test_serial_correlation(std::span<const double> values) {
    if (values.size() < fewest_for_serial_test || *moments_of(values).variance() == 0) return std::nullopt;
    const std::vector<double> x = centred(values);
    const double squares = sum_of_products(x, 0);
    SerialTest test = asymptotic_test(x, squares);
    // With few values, or values most of which are equal, small p-values differ much from those of random orders.
    constexpr double doubtful = 0.01;
    if (test.p < doubtful) test.p = std::max(test.p, share_of_orders(x, squares, test.p));
    test.detectable = (normal_critical(0.025) + normal_critical(0.1)) / std::sqrt(static_cast<double>(x.size()));
    return test;
}

Autocorrelation autocorrelation_of(std::span<const double> values) {
    const std::vector<double> x = centred(values);
    const auto n = static_cast<double>(x.size());
    const double squares = sum_of_products(x, 0);
    FF_EXPECT(squares > 0);
    double time = -1;
    double least_pair = 2;
    for (std::size_t lag = 0; lag + 1 < x.size(); lag += 2) {
        const double pair = (sum_of_products(x, lag) + sum_of_products(x, lag + 1)) / squares;
        if (pair <= 0) break;
        least_pair = std::min(least_pair, pair);
        time += 2 * least_pair;
    }
    if (time <= 1) return {.time = 1, .freedom = n};
    // About the sample's own mean each of some 2 time lags is too small by about time / n. The variance of the mean is
    // as uncertain as one of n / (3 time) values: sums over a window of twice that many lags, both ways [geyer1992].
    constexpr double least_left = 0.1;
    time /= std::max(least_left, 1 - 2 * time / n);
    return {.time = time, .freedom = n / (3 * time)};
}

}  // namespace ff::stats
