#pragma once

#include "core/radiosity/solver.hpp"

#include <functional>

namespace ff {

/// One iteration: changes the exitance. False where the method has come to its end.
using Iteration = std::function<bool(Eigen::VectorXd& exitance)>;

/// A method ready for a system.
struct IterativeMethod {
    double flops = 0;  ///< floating-point operations of an iteration
    Iteration iteration;
};

/// @param system  kept by reference @pre as `solve`; not `lu`
IterativeMethod method_for(const RadiositySystem& system, Solver solver, const SolverOptions& options);

}  // namespace ff
