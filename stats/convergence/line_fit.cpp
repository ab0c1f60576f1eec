#include "stats/convergence/line_fit.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ff::stats {
namespace {

PowerLaw with_residuals(double coefficient, double exponent, std::span<const double> sizes,
                        std::span<const double> errors) {
    PowerLaw law{.coefficient = coefficient, .exponent = exponent, .largest_residual = 0};
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const double residual = errors[i] * std::pow(sizes[i], exponent) / coefficient - 1;
        law.largest_residual = std::max(law.largest_residual, std::abs(residual));
    }
    return law;
}

}  // namespace

std::optional<LineFit> fit_line(std::span<const double> x, std::span<const double> y,
                                std::span<const double> variances) {
    FF_EXPECT(x.size() == y.size() && x.size() == variances.size());
    if (x.empty()) return std::nullopt;
    double weight = 0;
    double mean_x = 0;
    double mean_y = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        FF_EXPECT(variances[i] > 0);
        weight += 1 / variances[i];
        mean_x += (x[i] - mean_x) / (variances[i] * weight);
        mean_y += (y[i] - mean_y) / (variances[i] * weight);
    }
    double sum_xx = 0;
    double sum_xy = 0;
    bool distinct = false;
    for (std::size_t i = 0; i < x.size(); ++i) {
        distinct = distinct || x[i] != x.front();
        sum_xx += (x[i] - mean_x) * (x[i] - mean_x) / variances[i];
        sum_xy += (x[i] - mean_x) * (y[i] - mean_y) / variances[i];
    }
    if (!distinct) return std::nullopt;

    LineFit fit;
    fit.points = x.size();
    fit.slope = sum_xy / sum_xx;
    fit.intercept = mean_y - fit.slope * mean_x;
    fit.variance_slope = 1 / sum_xx;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double residual = y[i] - mean_y - fit.slope * (x[i] - mean_x);
        fit.chi_squared += residual * residual / variances[i];
    }
    fit.freedom = fit.points - 2;
    if (fit.freedom > 0) fit.lack_of_fit_p = chi_squared_tail(fit.chi_squared, static_cast<double>(fit.freedom));
    return fit;
}

Interval slope_interval_normal(const LineFit& fit, double level) {
    const double half = normal_critical((1 - level) / 2) * std::sqrt(fit.variance_slope);
    return interval_around(fit.slope, half, level, "wls_normal", fit.points);
}

std::optional<PowerLaw> fit_power_law(std::span<const double> sizes, std::span<const double> errors) {
    FF_EXPECT(sizes.size() == errors.size());
    std::vector<double> x;
    std::vector<double> y;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        FF_EXPECT(sizes[i] > 0);
        if (errors[i] * errors.front() <= 0) return std::nullopt;
        x.push_back(std::log(sizes[i]));
        y.push_back(std::log(std::abs(errors[i])));
    }
    const std::vector<double> equal(x.size(), 1.0);
    const auto line = fit_line(x, y, equal);
    if (!line) return std::nullopt;
    return with_residuals(std::copysign(std::exp(line->intercept), errors.front()), -line->slope, sizes, errors);
}

std::optional<PowerLaw> fit_power_law(std::span<const double> sizes, std::span<const double> errors, double exponent) {
    FF_EXPECT(sizes.size() == errors.size());
    if (sizes.empty()) return std::nullopt;
    double sum = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) sum += errors[i] * std::pow(sizes[i], exponent);
    if (sum == 0) return std::nullopt;
    return with_residuals(sum / static_cast<double>(sizes.size()), exponent, sizes, errors);
}

}  // namespace ff::stats
