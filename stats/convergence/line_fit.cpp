#include "stats/convergence/line_fit.hpp"

#include "core/support/contract.hpp"
#include "stats/basics/distributions.hpp"

#include <cmath>

namespace ff::stats {

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
    return {.low = fit.slope - half, .high = fit.slope + half, .level = level, .method = "wls_normal", .n = fit.points};
}

}  // namespace ff::stats
