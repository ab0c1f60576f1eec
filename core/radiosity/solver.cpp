#include "core/radiosity/solver.hpp"

#include "core/support/contract.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/LU>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <utility>

namespace ff {
namespace {

/// One iteration: changes the exitance. False where the method has come to its end.
using Iteration = std::function<bool(Eigen::VectorXd& exitance)>;

/// A method ready for a system.
struct IterativeMethod {
    double flops = 0;  ///< floating-point operations of an iteration
    Iteration iteration;
};

/// m <- e + P F m, solved for each patch's own part.
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
    return [&system, relaxation, rows = Rows(system.factors)](Eigen::VectorXd& m) {
        for (Eigen::Index i = 0; i < system.size(); ++i) {
            const double own = system.reflectance[i] * system.factors(i, i);
            const double gathered = system.reflectance[i] * rows.row(i).dot(m) - own * m[i];
            m[i] += relaxation * ((system.emission[i] + gathered) / (1 - own) - m[i]);
        }
        return true;
    };
}

/// Semi-iteration with eigenvalues of P F in [-bound, bound]: m_k+1 = omega (e + P F m_k - m_k-1) + m_k-1.
Iteration chebyshev(const RadiositySystem& system, double bound) {
    return [&system, bound, before = Eigen::VectorXd(), omega = 0.0](Eigen::VectorXd& m) mutable {
        Eigen::VectorXd next = m + residual(system, m);
        if (omega == 0) {
            omega = 2;  // gives 1 / (1 - bound^2 / 2) next
        } else {
            omega = 1 / (1 - bound * bound * omega / 4);
            next = omega * (next - before) + before;
        }
        before = m;
        m = std::move(next);
        return true;
    };
}

/// The exitance that waits in the room, spread over it, is the sum of the unshot exitances times these: what the unshot
/// power becomes after all reflections, by the mean reflectance.
Eigen::VectorXd ambient_shares(const RadiositySystem& system) {
    const double total = system.areas.sum();
    const double mean = system.reflectance.dot(system.areas) / total;
    return system.areas / (total * (1 - mean));
}

/// n shots. Each goes from the patch with most unshot power; `ambient` adds what will come back to it, as if it were
/// there already, which leaves the patch with negative unshot power.
Iteration shooting(const RadiositySystem& system, const std::optional<Eigen::VectorXd>& ambient) {
    return [&system, ambient, unshot = residual(system, system.emission)](Eigen::VectorXd& m) mutable {
        for (Eigen::Index shot = 0; shot < system.size(); ++shot) {
            Eigen::VectorXd to_shoot = unshot;
            if (ambient) to_shoot += ambient->dot(unshot) * system.reflectance;
            Eigen::Index from = 0;
            to_shoot.cwiseProduct(system.areas).cwiseAbs().maxCoeff(&from);
            // The power that the patch sends to itself is already part of the ambient exitance.
            const double own = ambient ? 0 : system.reflectance[from] * system.factors(from, from);
            const double change = to_shoot[from] / (1 - own);
            m[from] += change;
            unshot[from] -= change;
            unshot += change * system.reflectance.cwiseProduct(system.factors.col(from));
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
        // Eigen tells no residuals on the way: it starts again with one step more each time. The flops are those of
        // one run.
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

/// @param system  kept by reference
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
            return {matrix_vector + 5 * n, chebyshev(system, system.reflectance.maxCoeff())};
        case Solver::conjugate_gradient:
            return {matrix_vector + 10 * n, conjugate_gradient(system)};
        case Solver::progressive_refinement:
            return {4 * n * n, shooting(system, std::nullopt)};
        case Solver::overshooting:
            return {8 * n * n, shooting(system, ambient_shares(system))};
        case Solver::lu:
            break;
    }
    FF_EXPECT(solver != Solver::lu);
    return {};
}

constexpr double hopeless = 1e10;     // times the first residual
constexpr std::size_t patience = 50;  // iterations within which the residual has to fall

double relative_residual(const RadiositySystem& system, const Eigen::VectorXd& exitance) {
    return residual(system, exitance).cwiseAbs().maxCoeff() / system.emission.maxCoeff();
}

SolverRun eliminate(const RadiositySystem& system) {
    SolverRun run;
    run.residuals.push_back(relative_residual(system, system.emission));
    const auto n = static_cast<double>(system.size());
    run.flops = 2 * n * n * n / 3 + 2 * n * n;
    const auto exitance = solve_exactly(system);
    run.outcome = exitance ? SolverOutcome::converged : SolverOutcome::diverged;
    run.exitance = exitance.value_or(system.emission);
    run.residuals.push_back(relative_residual(system, run.exitance));
    return run;
}

/// Repeats an iteration and watches the residual, so that divergence is recognised whatever the method.
SolverRun iterate(const RadiositySystem& system, const SolverOptions& options, const IterativeMethod& method) {
    SolverRun run;
    run.exitance = system.emission;
    run.residuals.push_back(relative_residual(system, run.exitance));
    const auto outcome = [&]() -> std::optional<SolverOutcome> {
        const double now = run.residuals.back();
        if (now <= options.tolerance) return SolverOutcome::converged;
        if (!std::isfinite(now) || now > hopeless * run.residuals.front()) return SolverOutcome::diverged;
        if (run.iterations() >= options.most_iterations) return SolverOutcome::exhausted;
        if (run.iterations() < 2 * patience) return std::nullopt;  // it may rise at first
        const double before = run.residuals[run.iterations() - patience];
        if (now < before) return std::nullopt;
        return now > before ? SolverOutcome::diverged : SolverOutcome::stalled;
    };
    std::optional<SolverOutcome> ended = outcome();
    while (!ended) {
        const bool goes_on = method.iteration(run.exitance);
        run.flops += method.flops;
        run.residuals.push_back(relative_residual(system, run.exitance));
        ended = outcome();
        if (!goes_on && !ended) ended = SolverOutcome::stalled;
    }
    run.outcome = *ended;
    return run;
}

}  // namespace

std::string_view name(Solver solver) {
    static constexpr std::array<std::string_view, all_solvers.size()> names{
        "jacobi", "gauss_seidel", "sor", "chebyshev", "conjugate_gradient", "progressive_refinement", "overshooting",
        "lu"};
    return names.at(static_cast<std::size_t>(solver));
}

SolverRun solve(const RadiositySystem& system, Solver solver, const SolverOptions& options) {
    FF_EXPECT(system.emission.maxCoeff() > 0);
    FF_EXPECT(options.tolerance > 0 && options.relaxation > 0 && options.relaxation < 2);
    if (solver == Solver::lu) return eliminate(system);
    return iterate(system, options, method_for(system, solver, options));
}

std::optional<Eigen::VectorXd> solve_exactly(const RadiositySystem& system) {
    const Eigen::PartialPivLU<Eigen::MatrixXd> factorised(coefficient_matrix(system));
    if (!(factorised.rcond() > std::numeric_limits<double>::epsilon())) return std::nullopt;
    return Eigen::VectorXd(factorised.solve(system.emission));
}

}  // namespace ff
