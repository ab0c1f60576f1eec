#pragma once

#include "studies/radiosity/consequences.hpp"

#include <span>
#include <vector>

namespace ff::studies::radiosity {

/// @pre values not empty
OverTrials over_trials(std::span<const double> values);

/// Runs every solver on the systems of some trials and collects the results.
class SolverRuns {
  public:
    void add(const RadiositySystem& system, const SolverOptions& options);
    /// Empty where no system was added.
    std::vector<SolverStatistics> finish();

  private:
    struct OfSolver {
        SolverStatistics statistics;
        std::vector<double> iterations, flops;  // of the runs that converged
    };
    std::vector<OfSolver> solvers_;
};

}  // namespace ff::studies::radiosity
