#pragma once

#include <optional>
#include <span>

namespace ff::stats {

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
