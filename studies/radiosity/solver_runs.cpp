#include "studies/radiosity/solver_runs.hpp"

#include "stats/basics/quantiles.hpp"

#include <utility>

namespace ff::studies::radiosity {

OverTrials over_trials(std::span<const double> values) {
    const auto ascending = stats::sorted(values);
    return {ascending.front(), stats::quantile(ascending, 0.5), ascending.back()};
}

void SolverRuns::add(const RadiositySystem& system, const SolverOptions& options) {
    if (solvers_.empty()) {
        for (const Solver solver : all_solvers) solvers_.emplace_back().statistics.solver = solver;
    }
    for (OfSolver& one : solvers_) {
        SolverRun run = solve(system, one.statistics.solver, options);
        ++one.statistics.runs;
        one.statistics.converged += run.outcome == SolverOutcome::converged;
        one.statistics.diverged += run.outcome == SolverOutcome::diverged;
        one.statistics.stalled += run.outcome == SolverOutcome::stalled;
        one.statistics.exhausted += run.outcome == SolverOutcome::exhausted;
        if (run.outcome == SolverOutcome::converged) {
            one.iterations.push_back(static_cast<double>(run.iterations()));
            one.flops.push_back(run.flops);
        }
        if (one.statistics.residuals.empty()) one.statistics.residuals = std::move(run.residuals);
    }
}

std::vector<SolverStatistics> SolverRuns::finish() {
    std::vector<SolverStatistics> statistics;
    for (OfSolver& one : solvers_) {
        if (!one.iterations.empty()) {
            one.statistics.iterations = over_trials(one.iterations);
            one.statistics.flops = over_trials(one.flops).median;
        }
        statistics.push_back(std::move(one.statistics));
    }
    return statistics;
}

}  // namespace ff::studies::radiosity
