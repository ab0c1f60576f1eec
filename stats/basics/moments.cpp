#include "stats/basics/moments.hpp"

#include "core/support/contract.hpp"

#include <cmath>

namespace ff::stats {
namespace {

std::optional<double> root(std::optional<double> value) {
    if (!value) return std::nullopt;
    return std::sqrt(*value);
}

}  // namespace

void Moments::add(double value) {
    FF_EXPECT(std::isfinite(value));
    const double x = value - reference_;
    const double before = static_cast<double>(count_);
    const double n = static_cast<double>(++count_);
    const double delta = x - offset_;
    const double step = delta / n;
    const double step2 = step * step;
    const double term = delta * step * before;
    offset_ += step;
    sum4_ += term * step2 * (n * n - 3 * n + 3) + 6 * step2 * sum2_ - 4 * step * sum3_;
    sum3_ += term * step * (n - 2) - 3 * step * sum2_;
    sum2_ += term;
}

std::optional<double> Moments::mean() const {
    if (count_ == 0) return std::nullopt;
    return reference_ + offset_;
}

std::optional<double> Moments::bias() const {
    if (count_ == 0) return std::nullopt;
    return offset_;
}

std::optional<double> Moments::variance() const {
    if (count_ < 2) return std::nullopt;
    return sum2_ / static_cast<double>(count_ - 1);
}

std::optional<double> Moments::standard_deviation() const {
    return root(variance());
}

std::optional<double> Moments::standard_error() const {
    if (count_ < 2) return std::nullopt;
    return std::sqrt(*variance() / static_cast<double>(count_));
}

std::optional<double> Moments::mean_squared_error() const {
    if (count_ == 0) return std::nullopt;
    return offset_ * offset_ + sum2_ / static_cast<double>(count_);
}

std::optional<double> Moments::root_mean_squared_error() const {
    return root(mean_squared_error());
}

std::optional<double> Moments::skewness() const {
    if (count_ < 3 || sum2_ == 0) return std::nullopt;
    const double n = static_cast<double>(count_);
    const double sd = std::sqrt(sum2_ / n);
    const double g1 = sum3_ / n / sd / sd / sd;
    return g1 * std::sqrt(n * (n - 1)) / (n - 2);
}

std::optional<double> Moments::excess_kurtosis() const {
    if (count_ < 4 || sum2_ == 0) return std::nullopt;
    const double n = static_cast<double>(count_);
    const double g2 = n * (sum4_ / sum2_ / sum2_) - 3;
    return (n - 1) / ((n - 2) * (n - 3)) * ((n + 1) * g2 + 6);
}

std::optional<double> Moments::variance_of_variance() const {
    if (count_ < 2 || sum2_ == 0) return std::nullopt;
    return sum4_ / sum2_ / sum2_ - 1 / static_cast<double>(count_);
}

Moments moments_of(std::span<const double> values, double reference) {
    Moments moments(reference);
    for (const double value : values) moments.add(value);
    return moments;
}

std::optional<double> skewness_standard_error(std::size_t n) {
    if (n < 3) return std::nullopt;
    const double x = static_cast<double>(n);
    return std::sqrt(6 * x * (x - 1) / ((x - 2) * (x + 1) * (x + 3)));
}

std::optional<double> excess_kurtosis_standard_error(std::size_t n) {
    if (n < 4) return std::nullopt;
    const double x = static_cast<double>(n);
    return 2 * *skewness_standard_error(n) * std::sqrt((x * x - 1) / ((x - 3) * (x + 5)));
}

}  // namespace ff::stats
