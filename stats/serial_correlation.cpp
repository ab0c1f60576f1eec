#include "stats/serial_correlation.hpp"

#include "core/support/contract.hpp"
#include "stats/distributions.hpp"
#include "stats/moments.hpp"

#include <algorithm>
#include <cmath>

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

}  // namespace

std::vector<double> autocorrelations(std::span<const double> values, std::size_t lags) {
    FF_EXPECT(lags < values.size());
    const std::vector<double> x = centred(values);
    const double squares = sum_of_products(x, 0);
    FF_EXPECT(squares > 0);
    std::vector<double> result;
    for (std::size_t lag = 1; lag <= lags; ++lag) result.push_back(sum_of_products(x, lag) / squares);
    return result;
}

std::optional<SerialTest> test_serial_correlation(std::span<const double> values) {
    if (values.size() < fewest_for_serial_test || *moments_of(values).variance() == 0) return std::nullopt;
    const auto n = static_cast<double>(values.size());
    SerialTest test;
    test.lags = std::min<std::size_t>(10, values.size() / 5);
    const std::vector<double> r = autocorrelations(values, test.lags);
    test.first = r[0];
    for (std::size_t k = 1; k <= test.lags; ++k)
        test.statistic += n * (n + 2) * r[k - 1] * r[k - 1] / (n - static_cast<double>(k));
    // Independent values have mean -1/n and variance (n - 2)^2 / (n^2 (n - 1)) at lag 1 [moran1948].
    const double z = (r[0] + 1 / n) * n * std::sqrt(n - 1) / (n - 2);
    const double any = chi_squared_tail(test.statistic, static_cast<double>(test.lags));
    test.p = std::min(1.0, 2 * std::min(normal_tail(z), any));
    test.detectable = (normal_critical(0.025) + normal_critical(0.1)) / std::sqrt(n);
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
