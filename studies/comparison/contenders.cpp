#include "studies/comparison/contenders.hpp"

#include "core/estimators/added.hpp"
#include "samplers/outside/added.hpp"
#include "studies/comparison/ranking.hpp"
#include "studies/point_files/file_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace ff::studies {
namespace {

/// The error of a cell that takes part; null for a closed form, without a variance, and where it may be luck.
const ClassError* error_of(const Analysis& findings, std::size_t index, PairClass pair_class) {
    const CellAnalysis& found = findings.cells[index];
    const Cell& cell = findings.plan.cells[found.cell];
    const bool takes_part = !estimator_info(findings.plan.spec.methods[cell.method]).exact &&
                            !may_be_luck(findings.plan, cell) && !found.has_infinite_variance(pair_class);
    return takes_part ? found.class_error(pair_class) : nullptr;
}

/// Sets what a trial costs. @return whether that is known
bool set_cost(const StudyPlan& plan, const Costs& costs, Equal equal, Rung& rung) {
    if (equal == Equal::processor_time) {
        if (!costs[rung.cell]) return false;
        rung.cost = costs[rung.cell]->mean();
        rung.cost_error = costs[rung.cell]->relative_error();
    } else {
        rung.cost = static_cast<double>(evaluations_per_trial(plan, plan.cells[rung.cell]));
    }
    return rung.cost > 0;
}

/// Rung::bias of a cell in which none was found.
double possible_bias(const Analysis& findings, const CellAnalysis& found) {
    const Method& method = findings.plan.spec.methods[findings.plan.cells[found.cell].method];
    const auto* const sampler = samplers::find_added(method.sampler);
    const bool is_users =
        find_added_estimator(method.estimator) != nullptr || (sampler != nullptr && !names_point_file(method.sampler));
    if (!is_users) return 0;
    return found.bias && found.bias->shown_below > 0 ? found.bias->shown_below
                                                     : std::numeric_limits<double>::infinity();
}

std::optional<Rung> rung_of(const Analysis& findings, std::size_t index, PairClass pair_class) {
    const CellAnalysis& found = findings.cells[index];
    const Cell& cell = findings.plan.cells[found.cell];
    const ClassError* error = error_of(findings, index, pair_class);
    // No ratio to a value that is exact up to rounding is formed.
    if (error == nullptr || error->rmse < rounding_error) return std::nullopt;
    Rung rung;
    rung.cell = found.cell;
    rung.mean_square = std::pow(error->rmse, 2);
    rung.log_mean_square.value = std::log(rung.mean_square);
    if (cell.deterministic) return rung;
    if (!error->mean_square) return std::nullopt;
    rung.log_mean_square = stats::logarithm_of(*error->mean_square);
    rung.repeatable = found.bias_finding != BiasFinding::biased;
    rung.bias = possible_bias(findings, found);
    return rung;
}

}  // namespace

std::vector<Contender> contenders(const Analysis& findings, const Costs& costs, std::size_t scene, PairClass pair_class,
                                  Equal equal) {
    const StudyPlan& plan = findings.plan;
    std::map<std::pair<std::size_t, std::uint32_t>, std::vector<Rung>> of_patches;
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        const Cell& cell = plan.cells[i];
        if (cell.scene != scene) continue;
        auto rung = rung_of(findings, i, pair_class);
        if (rung && set_cost(plan, costs, equal, *rung)) of_patches[{cell.method, cell.subdivision.m}].push_back(*rung);
    }
    std::set<std::size_t> grow_by_samples;
    for (const auto& [of, rungs] : of_patches) {
        if (rungs.size() > 1) grow_by_samples.insert(of.first);
    }
    std::map<std::pair<std::size_t, std::uint32_t>, Contender> ladders;
    for (const auto& [of, rungs] : of_patches) {
        Contender& ladder = ladders[{of.first, grow_by_samples.contains(of.first) ? of.second : 0}];
        ladder.insert(ladder.end(), rungs.begin(), rungs.end());
    }
    std::vector<Contender> all;
    for (auto& [of, ladder] : ladders) {
        std::ranges::stable_sort(ladder, {},
                                 [&](const Rung& rung) { return evaluations_per_trial(plan, plan.cells[rung.cell]); });
        // Measured times vary: a larger size takes no less than a smaller one.
        for (std::size_t i = 1; i < ladder.size(); ++i) ladder[i].cost = std::max(ladder[i].cost, ladder[i - 1].cost);
        all.push_back(std::move(ladder));
    }
    return all;
}

std::vector<Rung> exact_sizes(const Analysis& findings, const Costs& costs, std::size_t scene, PairClass pair_class,
                              Equal equal) {
    const StudyPlan& plan = findings.plan;
    std::map<std::size_t, Rung> cheapest;
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        const ClassError* error = plan.cells[i].scene == scene ? error_of(findings, i, pair_class) : nullptr;
        const bool few = !plan.cells[i].deterministic && findings.cells[i].trials < 10;
        if (error == nullptr || error->rmse >= rounding_error || few) continue;
        Rung rung;
        rung.cell = findings.cells[i].cell;
        if (!set_cost(plan, costs, equal, rung)) continue;
        const auto [known, is_new] = cheapest.try_emplace(plan.cells[i].method, rung);
        if (!is_new && rung.cost < known->second.cost) known->second = rung;
    }
    std::vector<Rung> all;
    for (const auto& [method, rung] : cheapest) all.push_back(rung);
    return all;
}

}  // namespace ff::studies
