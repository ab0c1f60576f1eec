#pragma once

// Critical values for stats/gates/gate.hpp: C++17, the standard library alone. Those of the library are Boost's
// (stats/basics/distributions.hpp), which tests/unit/stats/gates/gate.cpp compares these with.

#include <algorithm>
#include <cmath>

namespace ff::gate {

namespace detail {

constexpr double pi = 3.14159265358979323846;

/// ln Gamma(a), a > 0.
inline double log_gamma(double a) {
    return std::lgamma(a);  // NOLINT(concurrency-mt-unsafe): nobody reads the sign, which it keeps for all threads
}

/// ln Gamma(a + 1/2) - ln Gamma(a); large arguments would cancel.
inline double log_gamma_step(double a) {
    if (a < 20) return log_gamma(a + 0.5) - log_gamma(a);
    const double r = 1 / (a * a);
    return 0.5 * std::log(a) - (1.0 / 8 - r * (1.0 / 192 - r * (1.0 / 640 - r * (17.0 / 14336)))) / a;
}

/// Continued fraction of the incomplete beta function [press2007] 6.4, by Lentz.
inline double beta_fraction(double a, double b, double x) {
    constexpr double tiny = 1e-300;
    const auto guarded = [](double value) { return std::abs(value) < tiny ? tiny : value; };
    double c = 1;
    double d = 1 / guarded(1 - (a + b) * x / (a + 1));
    double h = d;
    for (int i = 1; i < 100'000; ++i) {
        const double m = i;
        const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
        d = 1 / guarded(1 + even * d);
        c = guarded(1 + even / c);
        h *= d * c;
        const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
        d = 1 / guarded(1 + odd * d);
        c = guarded(1 + odd / c);
        h *= d * c;
        if (std::abs(d * c - 1) < 1e-16) break;
    }
    return h;
}

/// ln P(T > t) and the density over that probability, t > 0.
struct LogTail {
    double log_p;
    double hazard;
};

inline LogTail student_log_tail(double t, double freedom) {
    const double a = freedom / 2;
    const double log_density =
        log_gamma_step(a) - 0.5 * std::log(freedom * pi) - (a + 0.5) * std::log1p(t * t / freedom);
    const double density = std::exp(log_density);
    const double x = freedom / (freedom + t * t);
    // Either tail of the incomplete beta function has the factor x^a sqrt(1 - x) / B = density * t.
    const double log_p = x * (a + 2.5) < a + 1 ? log_density + std::log(t / freedom * beta_fraction(a, 0.5, x))
                                               : std::log(0.5 - density * t * beta_fraction(0.5, a, 1 - x));
    return {log_p, std::exp(log_density - log_p)};
}

inline LogTail normal_log_tail(double z) {
    const double log_p = std::log(std::erfc(z / std::sqrt(2.0)) / 2);
    return {log_p, std::exp(-z * z / 2 - log_p) / std::sqrt(2 * pi)};
}

/// ln P(X > x) (or P(X < x)) of chi-squared, by series or continued fraction [press2007] 6.2; for `upper` the hazard is
/// that of falling probabilities.
inline double gamma_tail(double a, double x, bool upper) {
    const double front = a * std::log(x) - x - log_gamma(a);
    if (x < a + 1) {
        double term = 1 / a;
        double sum = term;
        for (int k = 1; term > sum * 1e-17; ++k) sum += term *= x / (a + k);
        const double log_lower = front + std::log(sum);
        return upper ? std::log1p(-std::exp(log_lower)) : log_lower;
    }
    double b = x + 1 - a;
    double c = 1e300;
    double d = 1 / b;
    double h = d;
    for (int i = 1; i < 100'000; ++i) {
        const double an = -i * (i - a);
        b += 2;
        d = 1 / (an * d + b);
        c = b + an / c;
        h *= d * c;
        if (std::abs(d * c - 1) < 1e-16) break;
    }
    const double log_upper = front + std::log(h);
    return upper ? log_upper : std::log1p(-std::exp(log_upper));
}

/// Good to 5e-4 [abramowitz1964] 26.2.23; tail below 1/2.
inline double near_normal_critical(double tail) {
    const double t = std::sqrt(-2 * std::log(tail));
    const double z =
        t - (2.515517 + t * (0.802853 + t * 0.010328)) / (1 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
    return std::max(z, 1e-4);
}

/// Solves log_tail(x) = ln p by Newton's steps in ln x: tails are near to powers, or steeper, so that none overshoots
/// far.
template <class LogTailOf>
double solve_tail(double x, double log_p, const LogTailOf& tail_at) {
    for (int i = 0; i < 100; ++i) {
        const LogTail at = tail_at(x);
        const double step = std::clamp((at.log_p - log_p) / (at.hazard * x), -2.0, 2.0);
        x *= std::exp(step);
        if (std::abs(step) < 1e-8) break;  // the next would be its square
    }
    return x;
}

}  // namespace detail

/// z with P(Z > z) = tail, 0 < tail < 1.
inline double normal_critical(double tail) {
    if (tail == 0.5) return 0;
    if (tail > 0.5) return -normal_critical(1 - tail);
    return detail::solve_tail(detail::near_normal_critical(tail), std::log(tail), detail::normal_log_tail);
}

/// t with P(T > t) = tail for freedom > 0 (infinite: normal), 0 < tail < 1.
inline double student_critical(double freedom, double tail) {
    if (tail == 0.5) return 0;
    if (tail > 0.5) return -student_critical(freedom, 1 - tail);
    if (freedom > 1e15) return normal_critical(tail);
    const double z = detail::near_normal_critical(tail);
    const double q = z * z;
    // Cornish and Fisher's expansion [abramowitz1964] 26.7.5, where its terms fall.
    double start = z * (1 + (q + 1) / (4 * freedom));
    if (q < freedom) start += z * ((5 * q + 16) * q + 3) / (96 * freedom * freedom);
    return detail::solve_tail(start, std::log(tail),
                              [freedom](double t) { return detail::student_log_tail(t, freedom); });
}

/// x with P(X > x) = tail, X chi-squared, freedom > 0, 0 < tail < 1.
inline double chi_squared_critical(double freedom, double tail) {
    const double a = freedom / 2;
    const bool upper = tail <= 0.5;
    const double log_p = std::log(upper ? tail : 1 - tail);
    const double cube = 1 - 2 / (9 * freedom) + normal_critical(tail) * std::sqrt(2 / (9 * freedom));
    // Where Wilson and Hilferty's cube leaves its range, P(X < x) is near (x/2)^a / Gamma(a + 1).
    double x = cube > 0.1 ? freedom * cube * cube * cube : 2 * std::exp((log_p + detail::log_gamma(a + 1)) / a);
    for (int i = 0; i < 100; ++i) {
        const double at = detail::gamma_tail(a, x / 2, upper);
        const double slope =
            std::exp(a * std::log(x / 2) - x / 2 - detail::log_gamma(a) - at);  // derivative of ln P by ln x
        const double step = std::clamp((upper ? at - log_p : log_p - at) / slope, -2.0, 2.0);
        x *= std::exp(step);
        if (std::abs(step) < 1e-8) break;
    }
    return x;
}

}  // namespace ff::gate
