#include "core/radiosity/iteration.hpp"

#include "core/support/contract.hpp"

#include <Eigen/Core>
#include <Eigen/IterativeLinearSolvers>

#include <memory>
#include <utility>

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

/// Exitance that waits in the room, spread over it: what the unshot power becomes after all reflections, by the mean
/// reflectance.
struct Ambient {
    Eigen::VectorXd share;  // of each patch's unshot exitance

    explicit Ambient(const RadiositySystem& system) {
        const double total = system.areas.sum();
        const double mean = system.reflectance.dot(system.areas) / total;
        share = system.areas / (total * (1 - mean));
    }
};

/// n shots. Each goes from the patch with most unshot power; `ambient` adds what will come back to it, as if it were
/// there already, which leaves the patch with negative unshot power.
Iteration shooting(const RadiositySystem& system, std::shared_ptr<const Ambient> ambient) {
    return [&system, ambient = std::move(ambient),
            unshot = std::make_shared<Eigen::VectorXd>(residual(system, system.emission))](Eigen::VectorXd& m) {
        for (Eigen::Index shot = 0; shot < system.size(); ++shot) {
            Eigen::VectorXd to_shoot = *unshot;
            if (ambient) to_shoot += ambient->share.dot(*unshot) * system.reflectance;
            Eigen::Index from = 0;
            to_shoot.cwiseProduct(system.areas).cwiseAbs().maxCoeff(&from);
            // The power that the patch sends to itself is already part of the ambient exitance.
            const double own = ambient ? 0 : system.reflectance[from] * system.factors(from, from);
            const double change = to_shoot[from] / (1 - own);
            m[from] += change;
            (*unshot)[from] -= change;
            *unshot += change * system.reflectance.cwiseProduct(system.factors.col(from));
        }
        return true;
    };
}

// With S = A F, symmetric for reciprocal factors, and x = A^1/2 P^-1/2 (m - e), the system is (I - B) x = b with
// B = (P/A)^1/2 S (P/A)^1/2 and b = (P A)^1/2 F e: symmetric, positive definite where the spectral radius of P F is
// below 1, and without a division by reflectances, which may be 0.
Iteration conjugate_gradient(const RadiositySystem& system) {
    struct State {
        Eigen::VectorXd root;
        Eigen::MatrixXd symmetrised;
        Eigen::VectorXd right;
        Eigen::ConjugateGradient<Eigen::MatrixXd, Eigen::Lower | Eigen::Upper, Eigen::IdentityPreconditioner> eigen;
        // Eigen tells no residuals on the way: it starts again with one step more each time. The flops are those of a
        // run.
        Eigen::Index steps = 0;
    };
    const auto state = std::make_shared<State>();
    const Eigen::Index n = system.size();
    state->root = system.reflectance.cwiseQuotient(system.areas).cwiseSqrt();
    state->symmetrised = Eigen::MatrixXd::Identity(n, n) - state->root.asDiagonal() *
                                                               (system.areas.asDiagonal() * system.factors).eval() *
                                                               state->root.asDiagonal();
    const Eigen::VectorXd incident = system.factors * system.emission;
    state->right = state->root.cwiseProduct(system.areas).cwiseProduct(incident);
    state->eigen.compute(state->symmetrised);
    state->eigen.setTolerance(Eigen::NumTraits<double>::epsilon());
    return [&system, state](Eigen::VectorXd& exitance) {
        state->eigen.setMaxIterations(++state->steps);
        const Eigen::VectorXd x = state->eigen.solve(state->right);
        exitance = system.emission + state->root.cwiseProduct(x);
        return state->eigen.iterations() == state->steps;
    };
}

}  // namespace

IterativeMethod method_for(const RadiositySystem& system, Solver solver, const SolverOptions& options) {
    const auto n = static_cast<double>(system.size());
    const double matrix_vector = 2 * n * n;
    switch (solver) {
        case Solver::jacobi:
            return {matrix_vector + 4 * n, jacobi(system)};
        case Solver::gauss_seidel:
            return {matrix_vector + 4 * n, successive_relaxation(system, 1)};
        case Solver::sor:
            return {matrix_vector + 6 * n, successive_relaxation(system, options.relaxation)};
        case Solver::chebyshev:
            return {matrix_vector + 5 * n,
                    chebyshev(system, options.spectral_bound.value_or(system.reflectance.maxCoeff()))};
        case Solver::conjugate_gradient:
            return {matrix_vector + 10 * n, conjugate_gradient(system)};
        case Solver::progressive_refinement:
            return {4 * n * n, shooting(system, nullptr)};
        case Solver::overshooting:
            return {8 * n * n, shooting(system, std::make_shared<Ambient>(system))};
        case Solver::lu:
            break;
    }
    FF_EXPECT(solver != Solver::lu);
    return {};
}

}  // namespace ff
