#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace ff::stats {

/// The least (x - y)ᵀ C⁻¹ (x - y) over all points y of a box, with C the covariance of x: how far x lies outside the
/// box, in all coordinates together. Never above the true value, so that a test based on it keeps its level; a lower
/// bound where the descent has not converged.
/// @param covariance  row by row
/// @return empty where the covariance is not positive definite, up to rounding
/// @pre low <= high, all finite; as many of each as coordinates
std::optional<double> distance_to_box(std::span<const double> x, std::span<const double> low,
                                      std::span<const double> high, std::span<const double> covariance);

/// Whether a symmetric matrix with ones, or about ones, on its diagonal is positive definite, up to rounding.
/// @param matrix  row by row @pre size * size numbers
bool is_positive_definite(std::span<const double> matrix, std::size_t size);

}  // namespace ff::stats
