#pragma once

#include "core/radiosity/solver.hpp"

#include <functional>

namespace ff {

/// One iteration: changes the exitance. False where the method has come to its end.
using Iteration = std::function<bool(Eigen::VectorXd& exitance)>;

/// Repeats an iteration and watches the residual, so that divergence is recognised whatever the method.
SolverRun iterate(const RadiositySystem& system, const SolverOptions& options, double flops_per_iteration,
                  const Iteration& iteration);

/// @pre as `solve`
SolverRun solve_by_sweeps(const RadiositySystem& system, Solver solver, const SolverOptions& options);
SolverRun solve_by_shooting(const RadiositySystem& system, Solver solver, const SolverOptions& options);
SolverRun solve_by_conjugate_gradient(const RadiositySystem& system, const SolverOptions& options);

}  // namespace ff
