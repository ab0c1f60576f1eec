#include "core/radiosity/solver.hpp"

#include "core/radiosity/iteration.hpp"
#include "core/support/contract.hpp"

#include <Eigen/LU>

#include <cmath>
#include <limits>

namespace ff {
namespace {

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
