#pragma once

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

}  // namespace ff::stats
