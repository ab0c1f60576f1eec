#include "stats/dependence/correlation.hpp"

#include "core/points/stream.hpp"
#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"
#include "stats/basics/moments.hpp"
#include "stats/basics/resampling.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

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

int sign_of(double x) {
    return x > 0 ? 1 : x < 0 ? -1 : 0;
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

std::optional<double> p_of_independence(std::span<const double> values, std::size_t repetitions) {
    constexpr std::size_t fewest_repetitions = 4;
    if (repetitions < fewest_repetitions) return std::nullopt;
    FF_EXPECT(values.size() % repetitions == 0);
    // With variables as vectors of length 1 around their means, the sum of all squared products of two variables, which
    // are correlation coefficients, is that of the squared entries of the sum of their outer products.
    std::vector<double> outer(repetitions * repetitions);
    std::vector<double> centred(repetitions);
    double variables = 0;
    for (std::size_t first = 0; first < values.size(); first += repetitions) {
        const auto variable = values.subspan(first, repetitions);
        // From the first value on, so that a constant has no spread by rounding either.
        for (std::size_t i = 0; i < repetitions; ++i) centred[i] = variable[i] - variable[0];
        const double mean = std::accumulate(centred.begin(), centred.end(), 0.0) / static_cast<double>(repetitions);
        double squares = 0;
        for (std::size_t i = 0; i < repetitions; ++i) {
            centred[i] -= mean;
            squares += centred[i] * centred[i];
        }
        if (squares == 0) continue;
        ++variables;
        for (std::size_t i = 0; i < repetitions; ++i) {
            const double scaled = centred[i] / squares;
            for (std::size_t j = 0; j < repetitions; ++j) outer[i * repetitions + j] += scaled * centred[j];
        }
    }
    if (variables < 2) return std::nullopt;
    const double squares = std::inner_product(outer.begin(), outer.end(), outer.begin(), 0.0);
    const double of_pairs = std::max(0.0, (squares - variables) / 2);  // orthogonal variables: 0 but for rounding
    const auto freedom = static_cast<double>(repetitions - 1);
    const double pairs = variables * (variables - 1) / 2;
    const double mean = pairs / freedom;
    const double variance = pairs * 2 * (freedom - 1) / (freedom * freedom * (freedom + 2));
    return chi_squared_tail(2 * mean / variance * of_pairs, 2 * mean * mean / variance);
}

std::optional<RankCorrelation> rank_correlation(std::span<const double> first, std::span<const double> second,
                                                double level) {
    FF_EXPECT(first.size() == second.size());
    const std::size_t n = first.size();
    if (n < fewest_ranked) return std::nullopt;
    double agreement = 0;
    double of_first = 0;
    double of_second = 0;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const int a = sign_of(first[i] - first[j]);
            const int b = sign_of(second[i] - second[j]);
            agreement += a * b;
            of_first += a * a;
            of_second += b * b;
        }
    }
    if (of_first == 0 || of_second == 0) return std::nullopt;
    RankCorrelation found;
    found.tau = agreement / std::sqrt(of_first * of_second);
    const double z = normal_critical((1 - level) / 2);
    const double c = 2 * z * z / static_cast<double>(n);
    const double reach = std::sqrt(c * (1 + c - found.tau * found.tau));
    found.interval = {.low = (found.tau - reach) / (1 + c),
                      .high = (found.tau + reach) / (1 + c),
                      .level = level,
                      .method = "kendall_bound",
                      .n = n};
    return found;
}

}  // namespace ff::stats
