#pragma once

#include "stats/basics/interval.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace ff::stats {

/// y = intercept + slope x by weighted least squares with known variances of y.
struct LineFit {
    double intercept = 0;
    double slope = 0;
    double variance_slope = 0;
    double chi_squared = 0;               ///< sum of squared standardised residuals
    std::size_t freedom = 0;              ///< points - 2
    std::optional<double> lack_of_fit_p;  ///< P(chi-squared >= that); empty for two points
    std::size_t points = 0;
};

/// Empty below two distinct x. @pre equal lengths, variances > 0
std::optional<LineFit> fit_line(std::span<const double> x, std::span<const double> y,
                                std::span<const double> variances);

/// slope +- z sd: trusts the known variances.
Interval slope_interval_normal(const LineFit& fit, double level);
}  // namespace ff::stats
