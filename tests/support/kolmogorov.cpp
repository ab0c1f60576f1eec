#include "tests/support/kolmogorov.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/quantiles.hpp"
#include "stats/goodness_of_fit/anderson_darling.hpp"

#include <Eigen/Core>
#include <boost/math/special_functions/gamma.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace ff::test {
namespace {

/// A matrix times 10^exponent.
struct Scaled {
    Eigen::MatrixXd matrix;
    int exponent = 0;
};

Scaled operator*(const Scaled& a, const Scaled& b) {
    constexpr int step = 140;
    Scaled product{a.matrix * b.matrix, a.exponent + b.exponent};
    const Eigen::Index middle = product.matrix.rows() / 2;
    if (product.matrix(middle, middle) > 1e140) {
        product.matrix *= 1e-140;
        product.exponent += step;
    }
    return product;
}

Scaled power(Scaled base, std::size_t exponent) {
    Scaled result{Eigen::MatrixXd::Identity(base.matrix.rows(), base.matrix.cols())};
    for (; exponent > 0; exponent /= 2) {
        if (exponent % 2 == 1) result = result * base;
        if (exponent > 1) base = base * base;
    }
    return result;
}

/// P(D_n < d), exact. The work grows as (n d)^3 log n. @see [marsaglia2003]
double exact_cdf(std::size_t n, double d) {
    const double count = static_cast<double>(n);
    const auto k = static_cast<Eigen::Index>(count * d) + 1;
    const double h = static_cast<double>(k) - count * d;
    const Eigen::Index size = 2 * k - 1;

    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
    for (Eigen::Index i = 0; i < size; ++i) matrix.row(i).head(std::min(i + 2, size)).setOnes();
    for (Eigen::Index i = 0; i < size; ++i) {
        matrix(i, 0) -= std::pow(h, static_cast<double>(i + 1));
        matrix(size - 1, i) -= std::pow(h, static_cast<double>(size - i));
    }
    if (2 * h > 1) matrix(size - 1, 0) += std::pow(2 * h - 1, static_cast<double>(size));
    for (Eigen::Index i = 0; i < size; ++i) {
        double factorial = 1;
        for (Eigen::Index j = std::min(i, size - 1); j >= 0; --j) {
            factorial *= static_cast<double>(i - j + 1);
            matrix(i, j) /= factorial;
        }
    }

    Scaled result = power({std::move(matrix)}, n);
    double probability = result.matrix(k - 1, k - 1);
    for (std::size_t i = 1; i <= n; ++i) {
        probability *= static_cast<double>(i) / count;
        if (probability < 1e-140) {
            probability *= 1e140;
            result.exponent -= 140;
        }
    }
    return probability * std::pow(10.0, result.exponent);
}

/// P(D_n^+ > d), Smirnov's one-sided law: a sum of positive terms, so accurate however small.
double one_sided_tail(std::size_t n, double d) {
    const double count = static_cast<double>(n);
    const double log_factorial = boost::math::lgamma(count + 1);
    const auto last = static_cast<std::size_t>(count * (1 - d));
    double sum = 0;
    for (std::size_t i = 0; i <= last; ++i) {
        const double j = static_cast<double>(i);
        const double rest = 1 - d - j / count;
        if (rest <= 0) break;
        sum += std::exp(log_factorial - boost::math::lgamma(j + 1) - boost::math::lgamma(count - j + 1) +
                        (count - j) * std::log(rest) + (j - 1) * std::log(d + j / count));
    }
    return d * sum;
}

/// Tail of Kolmogorov's limiting law.
double limiting_tail(double z) {
    if (z < 1) {  // the dual series converges faster here
        double sum = 0;
        for (int i = 1; i <= 9; i += 2) {
            sum += std::exp(-i * i * std::numbers::pi * std::numbers::pi / (8 * z * z));
        }
        return 1 - std::sqrt(2 * std::numbers::pi) / z * sum;
    }
    double sum = 0;
    for (int i = 1; i <= 9; ++i) sum += (i % 2 == 1 ? 2 : -2) * std::exp(-2 * i * i * z * z);
    return sum;
}

}  // namespace

double kolmogorov_tail(std::size_t n, double d) {
    FF_EXPECT(n >= 1);
    const double count = static_cast<double>(n);
    if (d <= 0.5 / count) return 1;
    if (d >= 1) return 0;
    constexpr std::size_t largest_exact = 2000;
    constexpr std::size_t largest_sum = 100'000;
    // In the far tail both one-sided events together have a probability below 1e-13 of either.
    const bool far = count * d * d >= 4;
    if (far && n <= largest_sum) return std::min(1.0, 2 * one_sided_tail(n, d));
    if (n <= largest_exact) return std::clamp(1 - exact_cdf(n, d), 0.0, 1.0);
    const double z = std::sqrt(count) * d;
    return limiting_tail(z + 1 / (6 * std::sqrt(count)) + (z - 1) / (4 * count));
}

std::optional<KolmogorovTest> test_uniformity(std::span<const double> values) {
    if (values.empty()) return std::nullopt;
    std::vector<double> ascending = stats::sorted(values);
    for (double& value : ascending) value = std::clamp(value, 0.0, 1.0);
    const double distance = stats::kolmogorov_distance(ascending);
    return KolmogorovTest{.distance = distance, .p = kolmogorov_tail(ascending.size(), distance)};
}

}  // namespace ff::test
