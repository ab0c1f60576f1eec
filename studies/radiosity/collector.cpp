#include "studies/radiosity/collector.hpp"

#include "stats/basics/moments.hpp"
#include "stats/basics/quantiles.hpp"
#include "stats/means/mean_test.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ff::studies::radiosity {
namespace {

ExitanceStatistics summarise_exitance(std::size_t element, double exact, const std::vector<double>& values) {
    ExitanceStatistics statistics;
    statistics.element = element;
    statistics.exact = exact;
    const auto ascending = stats::sorted(values);
    statistics.q025 = stats::quantile(ascending, 0.025);
    statistics.median = stats::quantile(ascending, 0.5);
    statistics.q975 = stats::quantile(ascending, 0.975);
    return statistics;
}

void add_moments(ExitanceStatistics& statistics, const std::vector<double>& values, double level) {
    const auto moments = stats::moments_of(values, statistics.exact);
    statistics.mean = moments.mean();
    statistics.bias = moments.bias();
    statistics.bias_interval = stats::mean_interval(values, statistics.exact, level);
    statistics.std = moments.standard_deviation();
    statistics.rmse = moments.root_mean_squared_error();
}

/// Root mean square over pairs: of an element with itself where it sees itself.
double error_of(const Eigen::MatrixXd& factors, const Eigen::MatrixXd& exact, const Sight& sight) {
    const auto pairs = exact.size() - exact.rows() + sight.matrix().diagonal().count();
    return (factors - exact).norm() / std::sqrt(static_cast<double>(pairs));
}

/// @pre values not empty
OverTrials over_trials(std::span<const double> values) {
    const auto ascending = stats::sorted(values);
    return {ascending.front(), stats::quantile(ascending, 0.5), ascending.back()};
}

}  // namespace

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

std::vector<Eigen::VectorXd> solve_with_exact_factors(const Lighting& lighting, const SolverOptions& options,
                                                      std::size_t scene, std::uint32_t m,
                                                      const std::function<bool(std::size_t setting)>& with_solvers,
                                                      std::vector<ExactSystem>& systems) {
    std::vector<Eigen::VectorXd> exitance;
    RadiositySystem system = lighting.system(0, lighting.exact);
    for (std::size_t setting = 0; setting < lighting.reflectance.size(); ++setting) {
        system.reflectance = lighting.reflectance[setting];
        SolverRuns runs;
        if (with_solvers(setting)) runs.add(system, options);
        auto [properties, solution] = solve_with_properties(system);
        exitance.push_back(*solution);
        systems.push_back({scene, m, setting, std::move(*solution), properties, runs.finish()});
    }
    return exitance;
}

void SettingCollector::add(const RadiositySystem& system) {
    const auto [properties, exitance] = solve_with_properties(system);
    ++statistics_.trials;
    statistics_.dominant += properties.dominance > 0;
    statistics_.convergent += properties.spectral_radius.high < 1;
    statistics_.divergent += properties.spectral_radius.low >= 1;
    radius_.push_back(properties.spectral_radius.middle());
    statistics_.spectral_radius_uncertainty = std::max(
        statistics_.spectral_radius_uncertainty, properties.spectral_radius.high - properties.spectral_radius.low);
    condition_.push_back(properties.condition);
    if (!exitance) {
        ++statistics_.singular;
        return;
    }
    statistics_.negative += exitance->minCoeff() < 0;
    energy_.push_back(energy_balance(system, *exitance).defect());
    const auto elements = static_cast<std::size_t>(exitance->size());
    by_element_.resize(elements + 1);
    by_element_[0].push_back(system.areas.dot(*exitance) / system.areas.sum());
    for (std::size_t i = 0; i < elements; ++i) by_element_[i + 1].push_back((*exitance)[static_cast<Eigen::Index>(i)]);
}

SettingStatistics SettingCollector::finish(const Eigen::VectorXd& exact, const Eigen::VectorXd& areas, double level) {
    statistics_.solvers = solvers_.finish();
    statistics_.spectral_radius = over_trials(radius_);
    statistics_.condition = over_trials(condition_);
    if (!energy_.empty()) statistics_.energy_defect = over_trials(energy_);
    if (statistics_.singular > 0) return std::move(statistics_);
    const double mean = areas.dot(exact) / areas.sum();
    const bool has_moments = statistics_.trials == 1 || statistics_.convergent == statistics_.trials;
    double squares = 0;
    std::vector<double> of_trials(statistics_.trials, 0.0);  // mean squares
    for (std::size_t i = 0; i < by_element_.size(); ++i) {
        const double truth = i == 0 ? mean : exact[static_cast<Eigen::Index>(i) - 1];
        auto& found = statistics_.exitance.emplace_back(summarise_exitance(i, truth, by_element_[i]));
        if (has_moments) add_moments(found, by_element_[i], level);
        if (i > 0) squares += std::pow(found.rmse.value_or(0), 2);
        for (std::size_t trial = 0; i > 0 && trial < of_trials.size(); ++trial)
            of_trials[trial] += std::pow((by_element_[i][trial] - truth) / mean, 2) / static_cast<double>(exact.size());
    }
    if (!has_moments) return std::move(statistics_);
    statistics_.light_error = std::sqrt(squares / static_cast<double>(exact.size())) / mean;
    if (of_trials.size() < stats::fewest_replicates) return std::move(statistics_);
    const auto interval = stats::mean_interval(of_trials, 0, level);
    if (interval && interval->low > 0) statistics_.light_interval = stats::square_root(*interval);
    return std::move(statistics_);
}

ConsequencesCollector::ConsequencesCollector(const Lighting& lighting, std::span<const Eigen::VectorXd> exitance,
                                             Between between, Treatment treatment,
                                             std::vector<std::uint64_t> solver_trials, const SolverOptions& options)
    : lighting_(&lighting), exitance_(exitance), solver_trials_(std::move(solver_trials)), options_(options) {
    found_.between = between;
    found_.treatment = treatment;
    for (std::size_t setting = 0; setting < exitance.size(); ++setting) settings_.emplace_back(setting);
}

void ConsequencesCollector::add(const Eigen::MatrixXd& direct, const Eigen::VectorXd& rays) {
    Eigen::MatrixXd matrix = treat(lighting_->elements, rays, direct, found_.treatment);
    if (matrix.size() == 0) {
        ++found_.not_balanced;
        return;
    }
    const FactorProperties properties = factor_properties(matrix, lighting_->elements.areas);
    closure_.push_back(properties.closure_defect);
    reciprocity_.push_back(properties.reciprocity_defect);
    correction_.push_back((matrix - direct).cwiseAbs().maxCoeff());
    error_.push_back(error_of(matrix, lighting_->exact, lighting_->elements.sight));
    dominant_.push_back(properties.dominant_below());
    convergent_.push_back(1 / properties.spectral_radius.middle());
    RadiositySystem system = lighting_->system(0, std::move(matrix));
    for (std::size_t setting = 0; setting < settings_.size(); ++setting) {
        system.reflectance = lighting_->reflectance[setting];
        settings_[setting].add(system);
        if (found_.trials < solver_trials_[setting]) settings_[setting].run_solvers(system, options_);
    }
    ++found_.trials;
}

Consequences ConsequencesCollector::finish(std::size_t cell, double level) {
    found_.cell = cell;
    if (found_.trials == 0) return std::move(found_);
    found_.closure_defect = over_trials(closure_);
    found_.reciprocity_defect = over_trials(reciprocity_);
    found_.correction = over_trials(correction_);
    found_.factor_error = over_trials(error_);
    found_.dominant_below = over_trials(dominant_);
    found_.convergent_below = over_trials(convergent_);
    for (SettingCollector& setting : settings_) {
        const std::size_t index = found_.settings.size();
        found_.settings.push_back(setting.finish(exitance_[index], lighting_->elements.areas, level));
    }
    return std::move(found_);
}

}  // namespace ff::studies::radiosity
