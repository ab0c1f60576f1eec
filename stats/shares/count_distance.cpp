#include "stats/shares/count_distance.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"

#include <boost/math/special_functions/digamma.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace ff::stats {
namespace {

/// Cells joined to their neighbours: first[i] of one sample and second[i] of the other, or its expectation.
struct Cells {
    std::vector<double> first;
    std::vector<double> second;
};

/// Pools cells: from the first on, each takes its successors until enough are expected; the rest joins the last.
template <class Expected>
Cells pool_neighbours(std::span<const double> first, std::span<const double> second, const Expected& expected) {
    Cells cells;
    double a = 0;
    double b = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
        a += first[i];
        b += second[i];
        if (expected(a, b) < least_expected) continue;
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
    return std::accumulate(values.begin(), values.end(), 0.0);
}

/// o ln(o / e) - (o - e), accurately where the two are large and nearly equal.
double deviance(double o, double e) {
    if (o == 0) return e;
    const double d = (o - e) / e;
    return e * ((1 + d) * std::log1p(d) - d);
}

/// o (digamma(o) - ln o). Added to o ln o it makes the mean e ln e over Poisson's law of mean e [grassberger1988]: at
/// most exp(-e) is lacking, and with 0 instead of -1 for o = 0 at most as much is too much.
double less_bias(double o) {
    constexpr double many = 1000;
    if (o == 0) return -1;
    return o < many ? o * (boost::math::digamma(o) - std::log(o)) : -0.5 - 1 / (12 * o);
}

/// The contribution of a cell with e expected events to the variance of the statistic, beyond 2: 2 / (3 e) for many
/// events, and at most this from `least_expected` on.
double more_variance(double e) {
    constexpr double most = 0.76;
    return most / e;
}

/// Adds the part of one sample to the statistic. Returns n times the variance of ln(p / q) under p: the part of the
/// noncentral variance.
/// @param noise  share of the noise that is this sample's
double add_sample(CountDistance& found, const std::vector<double>& counts, const std::vector<double>& expected,
                  double noise) {
    double sum = -noise * static_cast<double>(counts.size()) / 2;  // sum of o ln(o / e), less its mean by chance
    double squares = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        found.statistic += 2 * (deviance(counts[i], expected[i]) + less_bias(counts[i]));
        found.variance += more_variance(expected[i]);
        if (counts[i] == 0) {
            found.empty += 2;
            continue;
        }
        const double ratio = std::log(counts[i] / expected[i]);
        sum += counts[i] * ratio;
        squares += counts[i] * ratio * ratio;
    }
    return squares - sum * sum / sum_of(counts);
}

/// The contribution of the number of cells. Noise is as large a part of `variance_of_ratios` as of the statistic;
/// dividing by a distance that may be noise could give any difference.
void complete(CountDistance& found, const std::vector<double>& smallest, double variance_of_ratios) {
    const auto cells = static_cast<double>(smallest.size());
    found.freedom = cells - 1;
    found.statistic = std::max(0.0, found.statistic + cells);
    found.variance += 2 * found.freedom;
    found.lattice = 2 / *std::min_element(smallest.begin(), smallest.end());
    const double noncentral = std::max(found.statistic - found.freedom, std::sqrt(found.variance));
    found.spread = 1 + std::max(0.0, variance_of_ratios - found.statistic) / noncentral;
}

/// Tail of the noncentral law with mean freedom + lambda and variance + 4 lambda spread.
double tail(const CountDistance& found, double lambda, bool above) {
    const double mean = found.freedom + lambda;
    const double scale = std::sqrt((found.variance + 4 * lambda * found.spread) / (2 * found.freedom + 4 * lambda));
    const double x = std::max(0.0, mean + (found.statistic - mean) / scale);
    if (lambda == 0) return above ? chi_squared_tail(x, found.freedom) : 1 - chi_squared_tail(x, found.freedom);
    return noncentral_chi_squared_tail(x, found.freedom, lambda, above);
}

/// The largest value for which `holds`, which holds up to it, or 0. @pre it does not hold for large ones
template <class Holds>
double last_value(double guess, const Holds& holds) {
    if (!holds(0.0)) return 0;
    double low = 0;
    double high = std::max(1.0, guess);
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

/// Kullback-Leibler divergence of the shares p and 1 - p from q and 1 - q.
double divergence(double p, double q) {
    const double hits = p > 0 ? p * std::log(p / q) : 0;
    return p < 1 ? hits + (1 - p) * (std::log1p(-p) - std::log1p(-q)) : hits;
}

}  // namespace

std::optional<CountDistance> count_distance(std::span<const double> counts, std::span<const double> shares) {
    FF_EXPECT(counts.size() == shares.size());
    CountDistance found;
    found.draws = sum_of(counts);
    std::vector<double> expected(shares.begin(), shares.end());
    for (double& value : expected) value *= found.draws;
    const Cells cells = pool_neighbours(counts, expected, [](double, double e) { return e; });
    if (cells.first.size() < 2) return std::nullopt;
    complete(found, cells.second, add_sample(found, cells.first, cells.second, 1));
    return found;
}

std::optional<CountDistance> count_distance_of_two(std::span<const double> first, std::span<const double> second) {
    FF_EXPECT(first.size() == second.size());
    const double n = sum_of(first);
    const double m = sum_of(second);
    if (n == 0 || m == 0) return std::nullopt;
    const Cells cells =
        pool_neighbours(first, second, [&](double a, double b) { return (a + b) * std::min(n, m) / (n + m); });
    if (cells.first.size() < 2) return std::nullopt;
    CountDistance found;
    found.draws = n * m / (n + m);
    std::vector<double> of_first(cells.first.size());
    std::vector<double> of_second(cells.first.size());
    for (std::size_t i = 0; i < of_first.size(); ++i) {
        const double together = cells.first[i] + cells.second[i];
        of_first[i] = together * n / (n + m);
        of_second[i] = together * m / (n + m);
        found.statistic -= 2 * less_bias(together);
        found.variance -= more_variance(together);
    }
    const double variance =
        add_sample(found, cells.first, of_first, m / (n + m)) + add_sample(found, cells.second, of_second, n / (n + m));
    complete(found, n < m ? of_first : of_second, variance);
    return found;
}

std::optional<std::size_t> refuting_bin(std::span<const double> counts, std::span<const double> shares, double w,
                                        double alpha) {
    FF_EXPECT(counts.size() == shares.size());
    const double n = sum_of(counts);
    double rare = 0;
    for (const double share : shares) rare += n * share < least_expected ? 1 : 0;
    std::optional<std::size_t> found;
    double least = std::log(rare / alpha);
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double seen = counts[i] / n;
        if (n * shares[i] >= least_expected || seen <= shares[i] || n * divergence(seen, shares[i]) < least) continue;
        // The part of `seen` that this bin can have in a distribution within the distance.
        const double part = last_value(1, [&](double of_seen) {
            const double share = of_seen * seen;
            return of_seen < 1 && (share <= shares[i] || 2 * divergence(share, shares[i]) <= w * w);
        });
        const double evidence = n * divergence(seen, part * seen);
        if (evidence <= least) continue;
        least = evidence;
        found = i;
    }
    return found;
}

double p_above(const CountDistance& found, double w) {
    return tail(found, found.draws * w * w, true);
}

Interval distance_interval(const CountDistance& found, double level) {
    const double alpha = (1 - level) / 2;
    const auto distance = [&](double lambda) { return std::sqrt(lambda / found.draws); };
    Interval interval{.level = level, .method = "noncentral_g", .n = static_cast<std::size_t>(found.draws)};
    interval.low =
        distance(last_value(found.statistic, [&](double lambda) { return tail(found, lambda, true) < alpha; }));
    CountDistance larger = found;
    const double root = std::sqrt(found.statistic + found.empty) + std::sqrt(found.lattice);
    // A better fit than the same distribution gives on average is luck, which shows no smaller distance.
    larger.statistic = std::max(root * root, found.freedom);
    interval.high =
        distance(last_value(larger.statistic, [&](double lambda) { return tail(larger, lambda, false) > alpha; }));
    return interval;
}

double detectable_distance(const CountDistance& found, double band, double alpha, double power) {
    CountDistance at = found;
    at.spread = 1;
    const double lambda = found.draws * band * band;
    // The least statistic that lies beyond the band.
    at.statistic = last_value(found.freedom + lambda, [&](double statistic) {
        at.statistic = statistic;
        return tail(at, lambda, true) > alpha / 2;
    });
    return std::sqrt(last_value(at.statistic, [&](double larger) { return tail(at, larger, true) < power; }) /
                     found.draws);
}

}  // namespace ff::stats
