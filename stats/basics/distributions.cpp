#include "stats/basics/distributions.hpp"

#include "core/support/contract.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <limits>

namespace ff::stats {

namespace math = boost::math;

namespace {

/// From here on Boost's series for chi-squared and F do not end, and a cube root is normal to seven digits
/// [wilson1931].
constexpr double most_freedom = 1e8;

/// Mean and standard deviation of (X / freedom)^(1/3), where X is chi-squared with that many degrees of freedom.
double cube_root_mean(double freedom) {
    return 1 - 2 / (9 * freedom);
}
double cube_root_sigma(double freedom) {
    return std::sqrt(2 / (9 * freedom));
}

/// Whether chi-squared lies beyond x with a probability that is 0 in doubles, by Chernoff's bound for either side;
/// Boost overflows there.
bool is_far(double x, double freedom) {
    constexpr double most_exponent = 750;
    return std::isinf(x) || (x - freedom - freedom * std::log(x / freedom)) / 2 > most_exponent;
}

/// Sankaran's standardised power of noncentral chi-squared.
double sankaran_score(double x, double freedom, double lambda) {
    const double mean = freedom + lambda;
    const double h = 1 - 2 * mean * (freedom + 3 * lambda) / (3 * (freedom + 2 * lambda) * (freedom + 2 * lambda));
    const double p = (freedom + 2 * lambda) / (mean * mean);
    const double m = (h - 1) * (1 - 3 * h);
    const double centre = 1 + h * p * (h - 1 - (2 - h) * m * p / 2);
    return (std::pow(x / mean, h) - centre) / (h * std::sqrt(2 * p) * (1 + m * p / 2));
}

/// ln f lies within the range of doubles; halved until neighbours are left.
double bisect_fisher(double tail, double freedom_above, double freedom_below) {
    double low = std::log(std::numeric_limits<double>::min());
    double high = std::log(std::numeric_limits<double>::max());
    while (true) {
        const double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high) return std::exp(middle);
        (fisher_tail(std::exp(middle), freedom_above, freedom_below) > tail ? low : high) = middle;
    }
}

}  // namespace

double normal_critical(double tail) {
    FF_EXPECT(0 < tail && tail < 1);
    return math::quantile(math::complement(math::normal(), tail));
}

double normal_tail(double z) {
    return math::cdf(math::complement(math::normal(), z));
}

double normal_two_sided_p(double z) {
    return 2 * normal_tail(std::abs(z));
}

double student_critical(double freedom, double tail) {
    FF_EXPECT(freedom > 0 && 0 < tail && tail < 1);
    // Intervals of a million estimates ask for a few quantiles in turn, each of which takes microseconds.
    struct Known {
        double freedom = 0;
        double tail = 0;
        double quantile = 0;
    };
    constexpr std::size_t asked_in_turn = 4;
    thread_local std::array<Known, asked_in_turn> known;
    thread_local std::size_t oldest = 0;
    for (const Known& one : known) {
        if (one.freedom == freedom && one.tail == tail) return one.quantile;
    }
    Known& found = known[oldest];
    oldest = (oldest + 1) % known.size();
    found = {freedom, tail, math::quantile(math::complement(math::students_t(freedom), tail))};
    return found.quantile;
}

double student_tail(double t, double freedom) {
    FF_EXPECT(freedom > 0);
    return math::cdf(math::complement(math::students_t(freedom), t));
}

double student_two_sided_p(double t, double freedom) {
    return 2 * student_tail(std::abs(t), freedom);
}

double chi_squared_critical(double freedom, double tail) {
    FF_EXPECT(freedom > 0 && 0 < tail && tail < 1);
    if (freedom > most_freedom)
        return freedom * std::pow(cube_root_mean(freedom) + cube_root_sigma(freedom) * normal_critical(tail), 3);
    return math::quantile(math::complement(math::chi_squared(freedom), tail));
}

double chi_squared_tail(double x, double freedom) {
    FF_EXPECT(x >= 0 && freedom > 0);
    if (is_far(x, freedom)) return x > freedom ? 0 : 1;
    if (freedom > most_freedom)
        return normal_tail((std::cbrt(x / freedom) - cube_root_mean(freedom)) / cube_root_sigma(freedom));
    return math::cdf(math::complement(math::chi_squared(freedom), x));
}

double noncentral_chi_squared_tail(double x, double freedom, double lambda, bool above) {
    FF_EXPECT(x >= 0 && freedom > 0 && lambda >= 0);
    if (x == 0) return above ? 1 : 0;
    const double score = sankaran_score(x, freedom, lambda) * (above ? 1 : -1);
    constexpr double normal_from = 1e4;
    constexpr double far = 30;  // tails below 1e-190, where Boost's series do not end
    if (freedom + lambda > normal_from || std::abs(score) > far) return normal_tail(score);
    try {
        const math::non_central_chi_squared law(freedom, lambda);
        return above ? math::cdf(math::complement(law, x)) : math::cdf(law, x);
    } catch (const std::exception&) {
        return normal_tail(score);
    }
}

double fisher_tail(double f, double freedom_above, double freedom_below) {
    FF_EXPECT(f >= 0);
    if (std::isinf(f)) return 0;
    const bool many_above = freedom_above > most_freedom;
    const bool many_below = freedom_below > most_freedom;
    // A mean square of many degrees of freedom is a constant beside one of few.
    if (many_above && many_below) return normal_tail(std::log(f) / std::sqrt(2 / freedom_above + 2 / freedom_below));
    if (many_below) return chi_squared_tail(f * freedom_above, freedom_above);
    if (many_above) {
        const double x = freedom_below / f;
        if (is_far(x, freedom_below)) return x > freedom_below ? 1 : 0;
        return math::cdf(math::chi_squared(freedom_below), x);
    }
    return math::cdf(math::complement(math::fisher_f(freedom_above, freedom_below), f));
}

double fisher_critical(double tail, double freedom_above, double freedom_below) {
    FF_EXPECT(0 < tail && tail < 1 && freedom_above > 0 && freedom_below > 0);
    if (std::max(freedom_above, freedom_below) > most_freedom) return bisect_fisher(tail, freedom_above, freedom_below);
    // Boost's iteration gives up at far tails and at degrees of freedom of very different size, loudly or not.
    double found = 0;
    try {
        found = math::quantile(math::complement(math::fisher_f(freedom_above, freedom_below), tail));
    } catch (const std::exception&) {
        return bisect_fisher(tail, freedom_above, freedom_below);
    }
    constexpr double close = 1e-6;
    const bool holds = found > 0 && std::isfinite(found) &&
                       std::abs(fisher_tail(found, freedom_above, freedom_below) - tail) <= close * tail;
    return holds ? found : bisect_fisher(tail, freedom_above, freedom_below);
}

}  // namespace ff::stats
