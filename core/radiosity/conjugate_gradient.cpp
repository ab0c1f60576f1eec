#include "core/radiosity/iteration.hpp"

#include <Eigen/Core>
#include <Eigen/IterativeLinearSolvers>

namespace ff {

// With S = A F, symmetric for reciprocal factors, and x = A^1/2 P^-1/2 (m - e), the system is (I - B) x = b with
// B = (P/A)^1/2 S (P/A)^1/2 and b = (P A)^1/2 F e: symmetric, positive definite where the spectral radius of P F is
// below 1, and without a division by reflectances, which may be 0.
SolverRun solve_by_conjugate_gradient(const RadiositySystem& system, const SolverOptions& options) {
    using Matrix = Eigen::MatrixXd;
    const Eigen::Index n = system.size();
    const Eigen::VectorXd root = system.reflectance.cwiseQuotient(system.areas).cwiseSqrt();
    const Matrix symmetrised = Matrix::Identity(n, n) - root.asDiagonal() *
                                                            (system.areas.asDiagonal() * system.factors).eval() *
                                                            root.asDiagonal();
    const Eigen::VectorXd incident = system.factors * system.emission;
    const Eigen::VectorXd right = root.cwiseProduct(system.areas).cwiseProduct(incident);
    Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper, Eigen::IdentityPreconditioner> eigen(symmetrised);
    eigen.setTolerance(Eigen::NumTraits<double>::epsilon());
    // Eigen tells no residuals on the way: it starts again with one step more each time. The flops are those of a run.
    Eigen::Index steps = 0;
    const auto size = static_cast<double>(n);
    return iterate(system, options, 2 * size * size + 10 * size, [&](Eigen::VectorXd& exitance) {
        eigen.setMaxIterations(++steps);
        const Eigen::VectorXd x = eigen.solve(right);
        exitance = system.emission + root.cwiseProduct(x);
        return eigen.iterations() == steps;
    });
}

}  // namespace ff
