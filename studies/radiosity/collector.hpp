#pragma once

#include "studies/radiosity/consequences.hpp"
#include "studies/radiosity/systems.hpp"

#include <functional>
#include <span>
#include <vector>

namespace ff::studies::radiosity {

/// Runs every solver on the systems of some trials and collects the results.
class SolverRuns {
  public:
    void add(const RadiositySystem& system, const SolverOptions& options);
    /// Empty where no system was added.
    std::vector<SolverStatistics> finish();

  private:
    struct OfSolver {
        SolverStatistics statistics;
        std::vector<double> iterations, flops;  // one for each run that converged
    };
    std::vector<OfSolver> solvers_;
};

/// Solves the systems of a lighting with exact factors, and adds them to `systems`.
/// @param scene, m  as of ExactSystem @param with_solvers  whether every solver is run, by setting
/// @return their exitances, by setting
std::vector<Eigen::VectorXd> solve_with_exact_factors(const Lighting& lighting, const SolverOptions& options,
                                                      std::size_t scene, std::uint32_t m,
                                                      const std::function<bool(std::size_t setting)>& with_solvers,
                                                      std::vector<ExactSystem>& systems);

/// Collects the trials of one setting.
class SettingCollector {
  public:
    explicit SettingCollector(std::size_t setting) { statistics_.setting = setting; }

    void add(const RadiositySystem& system);
    void run_solvers(const RadiositySystem& system, const SolverOptions& options) { solvers_.add(system, options); }
    SettingStatistics finish(const Eigen::VectorXd& exact, const Eigen::VectorXd& areas, double level);

  private:
    SettingStatistics statistics_;
    SolverRuns solvers_;
    std::vector<double> radius_, condition_, energy_;
    std::vector<std::vector<double>> by_element_;  // all elements together, then each element
};

/// Collects all trials of a cell under one treatment. Matrices are processed one by one and not kept.
class ConsequencesCollector {
  public:
    /// @param exitance exact solutions, by setting @param solver_trials how many trials solvers are run on, by setting
    ConsequencesCollector(const Lighting& lighting, std::span<const Eigen::VectorXd> exitance, Between between,
                          Treatment treatment, std::vector<std::uint64_t> solver_trials, const SolverOptions& options);

    /// @param rays  as of `treat`
    void add(const Eigen::MatrixXd& direct, const Eigen::VectorXd& rays);
    Consequences finish(std::size_t cell, double level);

  private:
    const Lighting* lighting_;
    std::span<const Eigen::VectorXd> exitance_;
    std::vector<std::uint64_t> solver_trials_;
    SolverOptions options_;
    Consequences found_;
    std::vector<double> closure_, reciprocity_, correction_, error_, dominant_, convergent_;
    std::vector<SettingCollector> settings_;
};

}  // namespace ff::studies::radiosity
