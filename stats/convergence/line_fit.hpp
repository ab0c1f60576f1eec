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

/// error = coefficient / size^exponent, for deterministic errors.
struct PowerLaw {
    double coefficient = 0;  ///< signed
    double exponent = 0;
    double largest_residual = 0;  ///< largest |error / law - 1| over the sizes
};

/// Fits both by least squares of ln|error|. Empty below two distinct sizes, or unless all errors have one sign.
/// @pre equal lengths, sizes > 0
std::optional<PowerLaw> fit_power_law(std::span<const double> sizes, std::span<const double> errors);

/// The coefficient alone: the mean of error * size^exponent. Empty without points or where it is 0.
std::optional<PowerLaw> fit_power_law(std::span<const double> sizes, std::span<const double> errors, double exponent);

}  // namespace ff::stats
