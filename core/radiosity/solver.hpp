#pragma once

#include "core/radiosity/system.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace ff {

/// Methods for radiosity systems. An iteration is a sweep over all patches; of the shooting methods it is n shots.
enum class Solver {
    jacobi,                  ///< all patches from the values of the previous sweep [young1971]
    gauss_seidel,            ///< each patch from the newest values: gathering
    sor,                     ///< Gauss-Seidel, each change multiplied by SolverOptions::relaxation
    chebyshev,               ///< m + P F m accelerated, for eigenvalues within ± the largest reflectance [golub1961]
    conjugate_gradient,      ///< Eigen's, on the symmetrised system; factors that are not reciprocal mislead it
    progressive_refinement,  ///< Southwell's relaxation: the patch with most unshot power shoots [cohen1988]
    overshooting,            ///< the same, each shot with an estimate of what will come back [feda1992]
    lu,                      ///< Gaussian elimination with pivoting: exact up to rounding
};

inline constexpr std::array all_solvers{Solver::jacobi,
                                        Solver::gauss_seidel,
                                        Solver::sor,
                                        Solver::chebyshev,
                                        Solver::conjugate_gradient,
                                        Solver::progressive_refinement,
                                        Solver::overshooting,
                                        Solver::lu};

std::string_view name(Solver solver);

struct SolverOptions {
    double tolerance = 1e-6;  ///< limit of the residual: largest |e - G m| <= tolerance * largest e
    std::size_t most_iterations = 100'000;
    double relaxation = 1.1;  ///< factor on each change by `sor`, in (0, 2)
};

enum class SolverOutcome {
    converged,
    diverged,   ///< the residual grows, or is not a number
    stalled,    ///< it has not fallen for some iterations
    exhausted,  ///< it falls, but too slowly for most_iterations
};

struct SolverRun {
    SolverOutcome outcome = SolverOutcome::exhausted;
    Eigen::VectorXd exitance;       ///< where the run ended, converged or not
    std::vector<double> residuals;  ///< largest |e - G m| / largest e: at the start (m = e), and after each iteration
    double flops = 0;  ///< additions and multiplications of the method; watching the residual is not counted

    [[nodiscard]] std::size_t iterations() const { return residuals.size() - 1; }
};

/// Starts from m = e. Ends when the residual is within the tolerance, or cannot get there.
/// @pre a physical system; some patch emits
SolverRun solve(const RadiositySystem& system, Solver solver, const SolverOptions& options = {});

/// The exact solution, up to rounding; empty where G is singular to working precision.
std::optional<Eigen::VectorXd> solve_exactly(const RadiositySystem& system);

}  // namespace ff
