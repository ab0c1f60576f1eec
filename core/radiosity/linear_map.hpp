#pragma once

#include <Eigen/Core>

#include <functional>

namespace ff {

/// A square matrix that is known by its products with vectors.
using LinearMap = std::function<Eigen::VectorXd(const Eigen::VectorXd& x)>;

/// Solves map(x) = right by iteration (BiCGSTAB).
/// @param guess      the first approximation
/// @param tolerance  largest residual, as a share of `right`
/// @return as near as this many iterations come; not finite where they break down
Eigen::VectorXd solve(const LinearMap& map, const Eigen::VectorXd& right, const Eigen::VectorXd& guess,
                      double tolerance, Eigen::Index most_iterations);

}  // namespace ff
