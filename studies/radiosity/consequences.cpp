#include "studies/radiosity/consequences.hpp"

#include "core/contract.hpp"
#include "core/exact.hpp"
#include "stats/mean_interval.hpp"
#include "stats/moments.hpp"
#include "stats/quantiles.hpp"
#include "studies/radiosity/solver_runs.hpp"

#include <algorithm>
#include <cmath>

namespace ff::studies {
namespace {

const RadiosityRequest& request_of(const StudyPlan& plan) {
    FF_EXPECT(plan.spec.radiosity.has_value());
    return *plan.spec.radiosity;
}

/// One number for each face.
Eigen::VectorXd for_faces(const std::vector<double>& numbers, Eigen::Index faces) {
    if (numbers.empty()) return Eigen::VectorXd::Unit(faces, faces - 1);
    if (numbers.size() == 1) return Eigen::VectorXd::Constant(faces, numbers.front());
    return Eigen::Map<const Eigen::VectorXd>(numbers.data(), faces);
}

ExitanceFindings summarise_exitance(int face, double exact, const std::vector<double>& values) {
    ExitanceFindings findings;
    findings.face = face;
    findings.exact = exact;
    const auto ascending = stats::sorted(values);
    findings.q025 = stats::quantile(ascending, 0.025);
    findings.median = stats::quantile(ascending, 0.5);
    findings.q975 = stats::quantile(ascending, 0.975);
    return findings;
}

void add_moments(ExitanceFindings& findings, const std::vector<double>& values, double level) {
    const auto moments = stats::moments_of(values, findings.exact);
    findings.mean = moments.mean();
    findings.bias = moments.bias();
    findings.bias_interval = stats::bias_interval_t(moments, level);
    findings.std = moments.standard_deviation();
    findings.rmse = moments.root_mean_squared_error();
}

/// Collects what the trials of one setting say.
class SettingCollector {
  public:
    explicit SettingCollector(std::size_t setting) { findings_.setting = setting; }

    void add(const RadiositySystem& system) {
        const SystemProperties properties = system_properties(system);
        ++findings_.trials;
        findings_.dominant += properties.dominance > 0;
        findings_.convergent += properties.spectral_radius.high < 1;
        findings_.divergent += properties.spectral_radius.low >= 1;
        radius_.push_back(properties.spectral_radius.middle());
        findings_.radius_uncertainty =
            std::max(findings_.radius_uncertainty, properties.spectral_radius.high - properties.spectral_radius.low);
        condition_.push_back(properties.condition);
        const auto exitance = solve_exactly(system);
        if (!exitance) {
            ++findings_.singular;
            return;
        }
        findings_.negative += exitance->minCoeff() < 0;
        energy_.push_back(energy_balance(system, *exitance).defect());
        const auto faces = static_cast<std::size_t>(exitance->size());
        by_face_.resize(faces + 1);
        by_face_[0].push_back(system.areas.dot(*exitance) / system.areas.sum());
        for (std::size_t i = 0; i < faces; ++i) by_face_[i + 1].push_back((*exitance)[static_cast<Eigen::Index>(i)]);
    }

    SettingFindings finish(const Eigen::VectorXd& exact, const Eigen::VectorXd& areas, double level) {
        findings_.spectral_radius = over_trials(radius_);
        findings_.condition = over_trials(condition_);
        if (!energy_.empty()) findings_.energy_defect = over_trials(energy_);
        if (findings_.singular > 0) return std::move(findings_);
        const double mean = areas.dot(exact) / areas.sum();
        const bool has_moments = findings_.trials == 1 || findings_.convergent == findings_.trials;
        double squares = 0;
        for (std::size_t i = 0; i < by_face_.size(); ++i) {
            const double truth = i == 0 ? mean : exact[static_cast<Eigen::Index>(i) - 1];
            auto& found = findings_.exitance.emplace_back(summarise_exitance(static_cast<int>(i), truth, by_face_[i]));
            if (has_moments) add_moments(found, by_face_[i], level);
            if (i > 0) squares += std::pow(found.rmse.value_or(0), 2);
        }
        if (has_moments) findings_.light_error = std::sqrt(squares / static_cast<double>(exact.size())) / mean;
        return std::move(findings_);
    }

  private:
    SettingFindings findings_;
    std::vector<double> radius_, condition_, energy_;
    std::vector<std::vector<double>> by_face_;  // all together, then each
};

/// The trials of a cell, treated, with what is said of the matrices themselves.
std::vector<Eigen::MatrixXd> treat_all(const TrialMatrices& trials, const Eigen::MatrixXd& exact, Consequences& found) {
    std::vector<Eigen::MatrixXd> matrices;
    std::vector<double> closure, reciprocity, correction, error, dominant, convergent;
    const auto pairs = static_cast<double>(exact.size() - exact.rows());
    for (const Eigen::MatrixXd& direct : trials.direct) {
        Eigen::MatrixXd matrix = treat(trials, direct, found.treatment);
        if (matrix.size() == 0) {
            ++found.not_balanced;
            continue;
        }
        const FactorProperties properties = factor_properties(matrix, trials.areas);
        closure.push_back(properties.closure_defect);
        reciprocity.push_back(properties.reciprocity_defect);
        correction.push_back((matrix - direct).cwiseAbs().maxCoeff());
        error.push_back((matrix - exact).norm() / std::sqrt(pairs));
        dominant.push_back(properties.dominant_below());
        convergent.push_back(1 / properties.spectral_radius.middle());
        matrices.push_back(std::move(matrix));
    }
    found.trials = matrices.size();
    if (matrices.empty()) return matrices;
    found.closure_defect = over_trials(closure);
    found.reciprocity_defect = over_trials(reciprocity);
    found.correction = over_trials(correction);
    found.factor_error = over_trials(error);
    found.dominant_below = over_trials(dominant);
    found.convergent_below = over_trials(convergent);
    return matrices;
}

}  // namespace

const ExactSystem& RadiosityResults::exact_system(std::size_t scene, std::size_t setting) const {
    return *std::find_if(exact.begin(), exact.end(),
                         [&](const ExactSystem& system) { return system.scene == scene && system.setting == setting; });
}

const Consequences* RadiosityResults::find(std::size_t cell, Treatment treatment) const {
    const auto found = std::find_if(consequences.begin(), consequences.end(),
                                    [&](const Consequences& c) { return c.cell == cell && c.treatment == treatment; });
    return found == consequences.end() ? nullptr : &*found;
}

RadiositySystem make_system(const StudyPlan& plan, std::size_t scene, std::size_t setting, Eigen::MatrixXd factors) {
    const RadiosityRequest& request = request_of(plan);
    const Eigen::Index faces = factors.rows();
    RadiositySystem system;
    system.factors = std::move(factors);
    system.areas.resize(faces);
    for (Eigen::Index i = 0; i < faces; ++i) system.areas[i] = face_area(plan.scenes[scene], static_cast<int>(i));
    system.reflectance = for_faces(request.reflectance[setting], faces);
    system.emission = for_faces(request.emission, faces);
    return system;
}

RadiosityResults evaluate_radiosity(const Store& store) {
    const StudyPlan& plan = store.plan();
    const RadiosityRequest& request = request_of(plan);
    const SolverOptions options{.tolerance = request.tolerance};
    RadiosityResults results;
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
        const Eigen::MatrixXd factors = exact_form_factors(plan.scenes[scene]).value();
        for (std::size_t setting = 0; setting < request.reflectance.size(); ++setting) {
            const RadiositySystem system = make_system(plan, scene, setting, factors);
            SolverRuns runs;
            runs.add(system, options);
            results.exact.push_back(
                {scene, setting, solve_exactly(system).value(), system_properties(system), runs.finish()});
        }
    }
    for (std::size_t cell = 0; cell < plan.cells.size(); ++cell) {
        const std::size_t scene = plan.cells[cell].scene;
        const Eigen::MatrixXd exact = exact_form_factors(plan.scenes[scene]).value();
        const TrialMatrices trials = load_matrices(store, cell);
        const Treatment own = treatment_of(plan.spec.methods[plan.cells[cell].method].completion);
        for (const Treatment treatment : all_treatments) {
            Consequences found;
            found.cell = cell;
            found.treatment = treatment;
            const auto matrices = treat_all(trials, exact, found);
            for (std::size_t setting = 0; setting < request.reflectance.size() && !matrices.empty(); ++setting) {
                SettingCollector collector(setting);
                SolverRuns runs;
                for (std::size_t trial = 0; trial < matrices.size(); ++trial) {
                    const RadiositySystem system = make_system(plan, scene, setting, matrices[trial]);
                    collector.add(system);
                    if (treatment == own && trial < request.solver_trials) runs.add(system, options);
                }
                found.settings.push_back(
                    collector.finish(results.exact_system(scene, setting).exitance, trials.areas, plan.spec.level));
                found.settings.back().solvers = runs.finish();
            }
            results.consequences.push_back(std::move(found));
        }
    }
    return results;
}

}  // namespace ff::studies
