#include "studies/radiosity/solver_runs.hpp"

#include "stats/basics/quantiles.hpp"

#include <utility>

namespace ff::studies {

OverTrials over_trials(std::span<const double> values) {
    const auto ascending = stats::sorted(values);
    return {ascending.front(), stats::quantile(ascending, 0.5), ascending.back()};
}

void SolverRuns::add(const RadiositySystem& system, const SolverOptions& options) {
    if (solvers_.empty()) {
        for (const Solver solver : all_solvers) solvers_.emplace_back().findings.solver = solver;
    }
    for (OfSolver& one : solvers_) {
        SolverRun run = solve(system, one.findings.solver, options);
        ++one.findings.runs;
        one.findings.converged += run.outcome == SolverOutcome::converged;
        one.findings.diverged += run.outcome == SolverOutcome::diverged;
        one.findings.stalled += run.outcome == SolverOutcome::stalled;
        one.findings.exhausted += run.outcome == SolverOutcome::exhausted;
        if (run.outcome == SolverOutcome::converged) {
            one.iterations.push_back(static_cast<double>(run.iterations()));
            one.flops.push_back(run.flops);
        }
        if (one.findings.residuals.empty()) one.findings.residuals = std::move(run.residuals);
    }
}

std::vector<SolverFindings> SolverRuns::finish() {
    std::vector<SolverFindings> findings;
    for (OfSolver& one : solvers_) {
        if (!one.iterations.empty()) {
            one.findings.iterations = over_trials(one.iterations);
            one.findings.flops = over_trials(one.flops).median;
        }
        findings.push_back(std::move(one.findings));
    }
    return findings;
}

}  // namespace ff::studies
