#include "stats/shares/count_distance.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"

#include <boost/math/distributions/non_central_chi_squared.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ff::stats {
namespace {

/// Cells joined to their neighbours: first[i] of one sample and second[i] of the other, or its expectation.
struct Cells {
    std::vector<double> first;
    std::vector<double> second;
};

/// From the first cell on, each takes its successors until enough are expected; what remains joins the last.
template <class Expected>
Cells pool_neighbours(std::span<const double> first, std::span<const double> second, const Expected& expected,
                      double least) {
    Cells cells;
    double a = 0;
    double b = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
        a += first[i];
        b += second[i];
        if (expected(a, b) < least) continue;
        cells.first.push_back(a);
        cells.second.push_back(b);
        a = b = 0;
    }
    if (!cells.first.empty()) {
        cells.first.back() += a;
        cells.second.back() += b;
    }
    return cells;
}

double sum_of(std::span<const double> values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum;
}

/// n times mean and variance of ln(p / q) under p: of one sample's part of G.
struct LogRatios {
    double sum = 0;
    double variance = 0;
};

LogRatios log_ratios(std::span<const double> counts, std::span<const double> expected) {
    const double n = sum_of(counts);
    LogRatios result;
    double squares = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i] == 0) continue;
        const double ratio = std::log(counts[i] / expected[i]);
        result.sum += counts[i] * ratio;
        squares += counts[i] * ratio * ratio;
    }
    result.variance = squares - result.sum * result.sum / n;
    return result;
}

double widened(double variance, double statistic) {
    return statistic > 0 ? std::max(1.0, variance / statistic) : 1;
}

/// Tail of the noncentral law with mean freedom + lambda and variance 2 freedom + 4 lambda spread.
double tail(const CountDistance& found, double lambda, bool above) {
    const double mean = found.freedom + lambda;
    const double scale = std::sqrt((2 * found.freedom + 4 * lambda * found.spread) / (2 * found.freedom + 4 * lambda));
    const double x = std::max(0.0, mean + (found.statistic - mean) / scale);
    if (lambda == 0) return above ? chi_squared_tail(x, found.freedom) : 1 - chi_squared_tail(x, found.freedom);
    const boost::math::non_central_chi_squared law(found.freedom, lambda);
    return above ? cdf(complement(law, x)) : cdf(law, x);
}

/// The largest lambda for which `holds`, which holds up to it. @pre it does not hold for large ones
template <class Holds>
double last_lambda(const CountDistance& found, const Holds& holds) {
    if (!holds(0.0)) return 0;
    double low = 0;
    double high = std::max(1.0, found.statistic);
    while (holds(high)) {
        low = high;
        high *= 2;
    }
    constexpr int halvings = 50;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (low + high) / 2;
        (holds(middle) ? low : high) = middle;
    }
    return low;
}

}  // namespace

std::optional<CountDistance> count_distance(std::span<const double> counts, std::span<const double> shares,
                                            double least_expected) {
    FF_EXPECT(counts.size() == shares.size());
    CountDistance found;
    found.draws = sum_of(counts);
    for (std::size_t i = 0; i < counts.size(); ++i) found.impossible |= counts[i] > 0 && shares[i] == 0;
    std::vector<double> expected(shares.begin(), shares.end());
    for (double& value : expected) value *= found.draws;
    const Cells cells = pool_neighbours(
        counts, expected, [](double, double e) { return e; }, least_expected);
    if (cells.first.size() < 2) return std::nullopt;
    const LogRatios ratios = log_ratios(cells.first, cells.second);
    found.statistic = std::max(0.0, 2 * ratios.sum);
    found.lattice = 2 / *std::min_element(cells.second.begin(), cells.second.end());
    found.freedom = static_cast<double>(cells.first.size() - 1);
    found.spread = widened(ratios.variance, found.statistic);
    return found;
}

std::optional<CountDistance> count_distance_of_two(std::span<const double> first, std::span<const double> second,
                                                   double least_expected) {
    FF_EXPECT(first.size() == second.size());
    const double n = sum_of(first);
    const double m = sum_of(second);
    if (n == 0 || m == 0) return std::nullopt;
    const Cells cells = pool_neighbours(
        first, second, [&](double a, double b) { return (a + b) * std::min(n, m) / (n + m); }, least_expected);
    if (cells.first.size() < 2) return std::nullopt;
    std::vector<double> of_first(cells.first.size());
    std::vector<double> of_second(cells.first.size());
    for (std::size_t i = 0; i < of_first.size(); ++i) {
        const double together = cells.first[i] + cells.second[i];
        of_first[i] = together * n / (n + m);
        of_second[i] = together * m / (n + m);
    }
    const LogRatios a = log_ratios(cells.first, of_first);
    const LogRatios b = log_ratios(cells.second, of_second);
    CountDistance found;
    found.draws = n * m / (n + m);
    found.statistic = std::max(0.0, 2 * (a.sum + b.sum));
    const auto& expected = n < m ? of_first : of_second;
    found.lattice = 2 / *std::min_element(expected.begin(), expected.end());
    found.freedom = static_cast<double>(cells.first.size() - 1);
    found.spread = widened(a.variance + b.variance, found.statistic);
    return found;
}

double p_above(const CountDistance& found, double w) {
    return tail(found, found.draws * w * w, true);
}

Interval distance_interval(const CountDistance& found, double level) {
    const double alpha = (1 - level) / 2;
    const auto distance = [&](double lambda) { return std::sqrt(lambda / found.draws); };
    Interval interval{.level = level, .method = "noncentral_g", .n = static_cast<std::size_t>(found.draws)};
    interval.low = distance(last_lambda(found, [&](double lambda) { return tail(found, lambda, true) < alpha; }));
    CountDistance larger = found;
    const double root = std::sqrt(found.statistic) + std::sqrt(found.lattice);
    larger.statistic = root * root;
    interval.high = distance(last_lambda(larger, [&](double lambda) { return tail(larger, lambda, false) > alpha; }));
    return interval;
}

double detectable_distance(const CountDistance& found, double band, double alpha, double power) {
    CountDistance at = found;
    at.spread = 1;
    const double lambda = found.draws * band * band;
    // The least statistic that lies beyond the band.
    at.statistic = lambda == 0
                       ? chi_squared_critical(found.freedom, alpha / 2)
                       : quantile(complement(boost::math::non_central_chi_squared(found.freedom, lambda), alpha / 2));
    return std::sqrt(last_lambda(at, [&](double larger) { return tail(at, larger, true) < power; }) / found.draws);
}

}  // namespace ff::stats
