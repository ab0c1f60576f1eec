#include "core/radiosity/iteration.hpp"

#include <memory>

namespace ff {
namespace {

/// m <- e + P F m, solved for the own part of each patch.
Iteration jacobi(const RadiositySystem& system) {
    return [&system](Eigen::VectorXd& m) {
        const Eigen::VectorXd own = system.reflectance.cwiseProduct(system.factors.diagonal());
        const Eigen::VectorXd gathered = system.reflectance.cwiseProduct(system.factors * m) - own.cwiseProduct(m);
        m = (system.emission + gathered).cwiseQuotient((1 - own.array()).matrix());
        return true;
    };
}

Iteration successive_relaxation(const RadiositySystem& system, double relaxation) {
    // Rows of a matrix that is stored by columns miss the cache at every element: many patches want them in a piece.
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    return [&system, relaxation, rows = std::make_shared<const Rows>(system.factors)](Eigen::VectorXd& m) {
        for (Eigen::Index i = 0; i < system.size(); ++i) {
            const double own = system.reflectance[i] * system.factors(i, i);
            const double gathered = system.reflectance[i] * rows->row(i).dot(m) - own * m[i];
            m[i] += relaxation * ((system.emission[i] + gathered) / (1 - own) - m[i]);
        }
        return true;
    };
}

/// Semi-iteration with eigenvalues of P F in [-bound, bound]: m_k+1 = omega (e + P F m_k - m_k-1) + m_k-1.
Iteration chebyshev(const RadiositySystem& system, double bound) {
    struct State {
        Eigen::VectorXd before;
        double omega = 0;  // of the last iteration; 0 before the first
    };
    return [&system, bound, state = std::make_shared<State>()](Eigen::VectorXd& m) {
        Eigen::VectorXd next = m + residual(system, m);
        const double omega = state->omega;
        if (omega == 0) {
            state->omega = 2;  // gives 1 / (1 - bound^2 / 2) next
        } else {
            state->omega = 1 / (1 - bound * bound * omega / 4);
            next = state->omega * (next - state->before) + state->before;
        }
        state->before = m;
        m = std::move(next);
        return true;
    };
}

}  // namespace

SolverRun solve_by_sweeps(const RadiositySystem& system, Solver solver, const SolverOptions& options) {
    const auto n = static_cast<double>(system.size());
    const double matrix_vector = 2 * n * n;
    switch (solver) {
        case Solver::jacobi:
            return iterate(system, options, matrix_vector + 4 * n, jacobi(system));
        case Solver::gauss_seidel:
            return iterate(system, options, matrix_vector + 4 * n, successive_relaxation(system, 1));
        case Solver::chebyshev: {
            const double bound = options.spectral_bound.value_or(system.reflectance.maxCoeff());
            return iterate(system, options, matrix_vector + 5 * n, chebyshev(system, bound));
        }
        default:
            return iterate(system, options, matrix_vector + 6 * n, successive_relaxation(system, options.relaxation));
    }
}

}  // namespace ff
