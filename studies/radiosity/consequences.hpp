#pragma once

#include "core/radiosity/solver.hpp"
#include "core/radiosity/system.hpp"
#include "stats/basics/interval.hpp"
#include "studies/radiosity/systems.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies::radiosity {

/// The elements that the rows of a system stand for.
enum class Between { faces, patches };

std::string_view name(Between between);

/// The distribution of a number over the trials of a cell.
struct OverTrials {
    double least = 0;
    double median = 0;
    double largest = 0;
};

/// The exitance of a face or patch, or the mean of all by area, over the trials: against the solution with exact
/// factors. Mean, bias and spread are given for single trials too, but are empty where one of several trials is not
/// convergent: as the spectral radius passes 1, the exitance passes a pole and has no mean.
struct ExitanceStatistics {
    std::size_t element = 0;  ///< face, or patch in the order of PatchOrder, from 1; 0 for all
    double exact = 0;
    std::optional<double> mean;
    std::optional<double> bias;
    std::optional<stats::Interval> bias_interval;  ///< Student's t; empty for one trial
    std::optional<double> std;                     ///< standard deviation of a trial; empty for one
    std::optional<double> rmse;
    double q025 = 0, median = 0, q975 = 0;  ///< quantiles 2.5 %, 50 % and 97.5 % of single trials
};

/// One solver on the systems of one setting.
struct SolverStatistics {
    Solver solver = Solver::jacobi;
    std::size_t runs = 0;
    std::size_t converged = 0, diverged = 0, stalled = 0, exhausted = 0;
    std::optional<OverTrials> iterations;  ///< number of iterations, in the runs that converged
    std::optional<double> flops;           ///< their median
    std::vector<double> residuals;         ///< SolverRun::residuals of the first trial
};

/// All trials of a cell under one treatment, at one setting of reflectances.
struct SettingStatistics {
    std::size_t setting = 0;  ///< index into RadiosityRequest::reflectance
    std::size_t trials = 0;
    std::size_t dominant = 0;    ///< trials with G strictly diagonally dominant
    std::size_t convergent = 0;  ///< trials with a spectral radius of P F certainly below 1
    std::size_t divergent = 0;   ///< those with a spectral radius certainly at least 1
    std::size_t singular = 0;    ///< trials with G singular to working precision: no exitance
    std::size_t negative = 0;    ///< trials with a solution that is negative somewhere: no exitance
    OverTrials spectral_radius;
    double spectral_radius_uncertainty = 0;  ///< largest width of its bounds
    OverTrials condition;
    std::optional<OverTrials> energy_defect;   ///< share of the emitted power that is lost; empty if all are singular
    std::vector<ExitanceStatistics> exitance;  ///< all together, then each; empty if some trial is singular
    /// Root mean square over trials and elements of the exitance's error, relative to the mean exact exitance; empty
    /// where the mean of ExitanceStatistics is.
    std::optional<double> light_error;
    std::optional<stats::Interval> light_interval;  ///< interval by the rule for means of squares; empty for few trials
    std::vector<SolverStatistics> solvers;          ///< one for each solver; only for the method's own completion
};

/// The results of one treatment of the estimates of one cell.
struct Consequences {
    std::size_t cell = 0;
    Between between = Between::faces;
    Treatment treatment = Treatment::direct;
    std::size_t trials = 0;
    std::size_t not_balanced = 0;   ///< trials for which balancing fails; they are left out
    OverTrials closure_defect;      ///< largest |row sum - 1|
    OverTrials reciprocity_defect;  ///< largest |F_ij - F_ji A_j / A_i|
    OverTrials correction;          ///< largest change of a factor by the treatment
    OverTrials factor_error;        ///< root mean square over pairs of F - exact
    OverTrials dominant_below;      ///< uniform reflectance below which G is strictly diagonally dominant
    OverTrials convergent_below;    ///< uniform reflectance below which the spectral radius of P F is below 1
    std::vector<SettingStatistics> settings;
};

/// The system of a scene with exact factors, at one setting.
struct ExactSystem {
    std::size_t scene = 0;
    std::uint32_t m = 0;  ///< between patches, m x m of a surface; 0: between faces
    std::size_t setting = 0;
    Eigen::VectorXd exitance;
    SystemProperties properties;
    std::vector<SolverStatistics> solvers;
};

struct Results {
    std::vector<ExactSystem> exact;          ///< between faces by scene and setting, then between patches by m too
    std::vector<Consequences> consequences;  ///< between faces by cell and treatment, then between patches

    /// @param m as of ExactSystem
    [[nodiscard]] const ExactSystem& exact_system(std::size_t scene, std::size_t setting, std::uint32_t m = 0) const;
    /// Null where the cell has none, for example because it has systems only between patches.
    [[nodiscard]] const Consequences* find(std::size_t cell, Treatment treatment,
                                           Between between = Between::faces) const;
};

/// Solves the radiosity systems of every trial. @pre the plan has a request; every estimate is finite
/// @param stop  once true, no further system between patches is begun; null: never
Results find_consequences(const Store& store, const std::atomic<bool>* stop = nullptr);

/// Trials whose systems between patches have been evaluated, and those that should be.
struct PatchTrials {
    std::uint64_t done = 0;
    std::uint64_t wanted = 0;

    [[nodiscard]] bool complete() const { return done == wanted; }
};

PatchTrials patch_trials(const StudyPlan& plan, const Results& results);

/// How the bias of the exitance, all faces together by area, falls along a ladder of sizes. Exitance is not linear in
/// the form factors: unbiased factors with errors of variance 1/N give it a bias of order 1/N.
struct BiasOrder {
    std::string label;  ///< label of the ladder
    std::size_t scene = 0;
    Treatment treatment = Treatment::direct;
    std::size_t setting = 0;
    struct Point {
        std::size_t cell = 0;
        double evaluations = 0;  ///< N, for a face
        double bias = 0;         ///< relative to the exact value
        double error = 0;        ///< its standard error
    };
    std::vector<Point> points;
    /// Slope of ln |bias| over ln N, by weighted least squares. Empty where at some size the bias is within three
    /// standard errors of 0: its logarithm would be meaningless.
    std::optional<double> slope;
    std::optional<stats::Interval> interval;
};

/// Finds bias orders on ladders of sampled methods that grow in samples: one per treatment and setting for which the
/// exitance has a mean and varies by more than rounding at every size.
std::vector<BiasOrder> bias_orders(const StudyPlan& plan, const Results& results);

}  // namespace ff::studies::radiosity
