#include "studies/radiosity/consequences.hpp"

#include "stats/convergence/line_fit.hpp"
#include "studies/plan/ladders.hpp"
#include "studies/plan/plan.hpp"
#include "studies/radiosity/collector.hpp"
#include "studies/radiosity/cost.hpp"
#include "studies/radiosity/systems.hpp"
#include "studies/run/work.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace ff::studies::radiosity {
namespace {

/// One collector for each treatment. Solvers are run on the method's own completion.
std::vector<ConsequencesCollector> make_collectors(const StudyPlan& plan, std::size_t cell, const Lighting& lighting,
                                                   const std::vector<Eigen::VectorXd>& exitance, Between between) {
    std::vector<std::uint64_t> solver_trials(exitance.size(), plan.spec.radiosity->solver_trials);
    for (std::size_t setting = 0; between == Between::patches && setting < solver_trials.size(); ++setting)
        solver_trials[setting] = runs_solvers(plan, static_cast<double>(lighting.elements.areas.size()), setting);
    const std::vector<std::uint64_t> none(exitance.size(), 0);
    const Treatment own = treatment_of(plan.spec.methods[plan.cells[cell].method].completion);
    std::vector<ConsequencesCollector> collectors;
    for (const Treatment treatment : all_treatments) {
        collectors.emplace_back(lighting, exitance, between, treatment, treatment == own ? solver_trials : none,
                                solver_options(plan));
    }
    return collectors;
}

void evaluate_between_faces(const Store& store, Results& results) {
    const StudyPlan& plan = store.plan();
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
        const Lighting lighting = light_faces(plan, scene);
        const auto always = [](std::size_t) { return true; };
        const auto exitance = solve_with_exact_factors(lighting, solver_options(plan), scene, 0, always, results.exact);
        for (std::size_t cell = 0; cell < plan.cells.size(); ++cell) {
            if (plan.cells[cell].scene != scene) continue;
            const TrialMatrices trials = load_matrices(store, cell);
            auto collectors = make_collectors(plan, cell, lighting, exitance, Between::faces);
            for (const Eigen::MatrixXd& direct : trials.direct) {
                for (ConsequencesCollector& collector : collectors) collector.add(direct, trials.rays);
            }
            for (ConsequencesCollector& collector : collectors)
                results.consequences.push_back(collector.finish(cell, plan.spec.level));
        }
    }
}

/// Trials of one cell, until `stop`: a trial is whole or left out.
void add_trials_between_patches(const StudyPlan& plan, std::size_t cell, std::uint64_t trials,
                                const Eigen::VectorXd& rays, std::vector<ConsequencesCollector>& collectors,
                                const std::atomic<bool>* stop) {
    try {
        for (std::uint64_t trial = 0; trial < trials; ++trial) {
            const Eigen::MatrixXd direct = trace_patch_factors(plan, cell, trial, stop);
            for (ConsequencesCollector& collector : collectors) collector.add(direct, rays);
        }
    } catch (const Interrupted&) {
    }
}

void evaluate_between_patches(const Store& store, Results& results, const std::atomic<bool>* stop) {
    const StudyPlan& plan = store.plan();
    const auto stopped = [stop] { return stop != nullptr && stop->load(); };
    std::map<std::pair<std::size_t, std::uint32_t>, std::vector<std::size_t>> by_patches;
    for (std::size_t cell = 0; cell < plan.cells.size(); ++cell) {
        if (has_patch_systems(plan, cell))
            by_patches[{plan.cells[cell].scene, plan.cells[cell].subdivision.m}].push_back(cell);
    }
    for (const auto& [key, cells] : by_patches) {
        if (stopped()) return;
        const auto [scene, m] = key;
        const Lighting lighting = light_patches(plan, scene, Subdivision{m});
        const auto affordable = [&, n = static_cast<double>(lighting.elements.areas.size())](std::size_t setting) {
            return runs_solvers(plan, n, setting);
        };
        const auto exitance =
            solve_with_exact_factors(lighting, solver_options(plan), scene, m, affordable, results.exact);
        for (const std::size_t cell : cells) {
            if (stopped()) return;
            const bool counted = estimator_info(plan.spec.methods[plan.cells[cell].method]).observes == Observes::hits;
            Eigen::VectorXd rays;
            if (counted)
                rays.setConstant(lighting.elements.areas.size(),
                                 static_cast<double>(plan.cells[cell].samples_per_patch));
            auto collectors = make_collectors(plan, cell, lighting, exitance, Between::patches);
            add_trials_between_patches(plan, cell, patch_trials(plan, cell), rays, collectors, stop);
            for (ConsequencesCollector& collector : collectors) {
                Consequences found = collector.finish(cell, plan.spec.level);
                if (found.trials + found.not_balanced > 0) results.consequences.push_back(std::move(found));
            }
        }
    }
}

void fit(BiasOrder& order, double level) {
    constexpr double certain = 3;  // standard errors
    std::vector<double> x, y, variances;
    for (const BiasOrder::Point& point : order.points) {
        if (std::abs(point.bias) < certain * point.error) return;
        x.push_back(std::log(point.evaluations));
        y.push_back(std::log(std::abs(point.bias)));
        variances.push_back(std::pow(point.error / point.bias, 2));
    }
    if (const auto line = stats::fit_line(x, y, variances)) {
        order.slope = line->slope;
        order.interval = stats::slope_interval_normal(*line, level);
    }
}

}  // namespace

std::string_view name(Between between) {
    return between == Between::faces ? "faces" : "patches";
}

const ExactSystem& Results::exact_system(std::size_t scene, std::size_t setting, std::uint32_t m) const {
    return *std::find_if(exact.begin(), exact.end(), [&](const ExactSystem& system) {
        return system.scene == scene && system.setting == setting && system.m == m;
    });
}

const Consequences* Results::find(std::size_t cell, Treatment treatment, Between between) const {
    const auto found = std::find_if(consequences.begin(), consequences.end(), [&](const Consequences& c) {
        return c.cell == cell && c.treatment == treatment && c.between == between;
    });
    return found == consequences.end() ? nullptr : &*found;
}

PatchTrials patch_trials(const StudyPlan& plan, const Results& results) {
    PatchTrials trials;
    for (std::size_t cell = 0; cell < plan.cells.size(); ++cell) {
        if (!has_patch_systems(plan, cell)) continue;
        trials.wanted += patch_trials(plan, cell);
        const Consequences* found = results.find(cell, Treatment::direct, Between::patches);
        if (found != nullptr) trials.done += found->trials;
    }
    return trials;
}

Results find_consequences(const Store& store, const std::atomic<bool>* stop) {
    Results results;
    evaluate_between_faces(store, results);
    evaluate_between_patches(store, results, stop);
    // In the order of cells, whichever subdivision was computed first.
    std::stable_sort(results.consequences.begin(), results.consequences.end(),
                     [](const Consequences& a, const Consequences& b) {
                         return std::pair(a.between, a.cell) < std::pair(b.between, b.cell);
                     });
    return results;
}

std::vector<BiasOrder> bias_orders(const StudyPlan& plan, const Results& results) {
    constexpr double rounding = 1e-9;  // relative rounding of a solution with condition 1e6
    std::vector<BiasOrder> orders;
    for (const Ladder& ladder : find_ladders(plan)) {
        if (ladder.growth != Growth::samples || plan.cells[ladder.cells.front()].deterministic) continue;
        for (const Treatment treatment : all_treatments) {
            for (std::size_t setting = 0; setting < plan.spec.radiosity->reflectance.size(); ++setting) {
                BiasOrder order{ladder.label, ladder.scene, treatment, setting, {}, {}, {}};
                for (const std::size_t cell : ladder.cells) {
                    const Consequences* found = results.find(cell, treatment);
                    if (found->settings.empty()) continue;
                    const auto& exitance = found->settings[setting].exitance;
                    if (exitance.empty() || exitance.front().std.value_or(0) <= rounding * exitance.front().exact)
                        continue;
                    const ExitanceStatistics& all = exitance.front();
                    const Cell& planned = plan.cells[cell];
                    order.points.push_back(
                        {cell, static_cast<double>(planned.samples_per_patch * planned.subdivision.per_part()),
                         *all.bias / all.exact, *all.std / std::sqrt(static_cast<double>(found->trials)) / all.exact});
                }
                if (order.points.size() != ladder.cells.size()) continue;
                fit(order, plan.spec.level);
                orders.push_back(std::move(order));
            }
        }
    }
    return orders;
}

}  // namespace ff::studies::radiosity
