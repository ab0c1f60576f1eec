#include "studies/trials/until.hpp"

#include "core/exact/known_factors.hpp"
#include "stats/means/mean_interval.hpp"
#include "studies/theory/known_variance.hpp"

#include <algorithm>

namespace ff::studies {
namespace {

/// The result of a cell's pilot for one pair.
struct PairPilot {
    std::optional<stats::Pilot> pilot;
    VarianceStatus variance = VarianceStatus::finite;
};

std::vector<PairPilot> pilots(const Store& store, std::size_t cell_index) {
    const StudyPlan& plan = store.plan();
    const Cell& cell = plan.cells[cell_index];
    const Scene& scene = plan.scenes[cell.scene];
    const Method& method = plan.spec.methods[cell.method];
    const CellEstimates estimates = load_estimates(store, cell_index);
    const KnownFactors known = known_factors(scene);
    const auto size = static_cast<std::size_t>(plan.spec.until->pilot);
    std::vector<PairPilot> found;
    for (const Quantity pair : distinct_pairs(estimates.faces, method.completion)) {
        PairPilot& one = found.emplace_back();
        one.variance = known_variance(method, scene, pair);
        const auto reference = known.at(pair.from - 1, pair.to - 1);
        if (one.variance == VarianceStatus::finite && too_few_hits(estimates.lattice(pair), reference, size))
            one.variance = VarianceStatus::sparse;
        if (one.variance == VarianceStatus::finite) {
            const auto limits = known_limits(method, scene, cell.subdivision, pair, estimates.samples_of_pair, size);
            one.pilot = stats::skewed_pilot_of(estimates.values(pair), size, limits.largest_part);
        }
    }
    return found;
}

std::uint64_t trials_of(const StoppingRule& rule, stats::Pilot pilot, double level) {
    return rule.goal == StoppingGoal::ci ? stats::trials_for_half_width(pilot, rule.target, level)
                                         : stats::trials_for_rmse(pilot, rule.target);
}

double achieved_by(const StoppingRule& rule, stats::Pilot pilot, double level, std::uint64_t trials) {
    return rule.goal == StoppingGoal::ci ? stats::half_width_of(pilot, trials, level) : stats::rmse_of(pilot, trials);
}

bool pilot_is_saved(const Store& store, std::size_t cell, const std::vector<bool>& finished) {
    const auto& units = store.plan().units;
    return std::ranges::all_of(units, [&](const WorkUnit& unit) {
        return unit.cell != cell || unit.first_trial >= store.plan().spec.until->pilot || finished[unit.index];
    });
}

/// The largest number that a judged pair requires; 0 where none can be judged.
std::uint64_t wanted_trials(const StudySpec& spec, const std::vector<PairPilot>& pairs) {
    std::uint64_t wanted = 0;
    for (const PairPilot& pair : pairs) {
        if (pair.pilot) wanted = std::max(wanted, trials_of(*spec.until, *pair.pilot, spec.level));
    }
    return wanted;
}

/// Rounded up to the end of the unit that contains the last of them.
std::uint64_t whole_units(const StudyPlan& plan, std::size_t cell, std::uint64_t trials) {
    std::uint64_t end = 0;
    for (const WorkUnit& unit : plan.units) {
        if (unit.cell == cell && unit.first_trial < trials) end = std::max(end, unit.first_trial + unit.trials);
    }
    return end;
}

std::uint64_t needed_trials(const Store& store, std::size_t cell, const std::vector<bool>& finished) {
    const StudyPlan& plan = store.plan();
    if (!plan.spec.until || plan.cells[cell].deterministic) return plan.cells[cell].trials;
    std::uint64_t trials = plan.spec.until->pilot;
    if (pilot_is_saved(store, cell, finished)) trials = std::max(trials, wanted_trials(plan.spec, pilots(store, cell)));
    return whole_units(plan, cell, trials);
}

UntilFinding why_not(const std::vector<PairPilot>& pairs) {
    UntilFinding why = UntilFinding::reached;
    for (const PairPilot& pair : pairs) {
        if (pair.variance == VarianceStatus::infinite) return UntilFinding::infinite_variance;
        if (pair.variance == VarianceStatus::sparse) why = UntilFinding::too_few_hits;
        if (pair.variance == VarianceStatus::finite && !pair.pilot && why == UntilFinding::reached)
            why = UntilFinding::no_spread;
    }
    return why;
}

}  // namespace

std::uint64_t needed_trials(const Store& store, std::size_t cell) {
    return needed_trials(store, cell, store.finished_units());
}

std::vector<bool> needed_units(const Store& store) {
    const StudyPlan& plan = store.plan();
    std::vector<bool> needed(plan.units.size(), true);
    if (!plan.spec.until) return needed;
    const auto finished = store.finished_units();
    std::vector<std::uint64_t> trials;
    for (std::size_t cell = 0; cell < plan.cells.size(); ++cell) trials.push_back(needed_trials(store, cell, finished));
    std::transform(plan.units.begin(), plan.units.end(), needed.begin(),
                   [&](const WorkUnit& unit) { return unit.first_trial < trials[unit.cell]; });
    return needed;
}

bool is_adaptively_complete(const Store& store) {
    const auto finished = store.finished_units();
    const auto needed = needed_units(store);
    return std::equal(finished.begin(), finished.end(), needed.begin(),
                      [](bool done, bool wanted) { return done || !wanted; });
}

bool all_reached(std::span<const UntilOutcome> outcomes) {
    return std::ranges::all_of(outcomes,
                               [](const UntilOutcome& outcome) { return outcome.finding == UntilFinding::reached; });
}

std::vector<UntilOutcome> until_outcomes(const Store& store) {
    const StudyPlan& plan = store.plan();
    std::vector<UntilOutcome> outcomes;
    if (!plan.spec.until) return outcomes;
    for (std::size_t cell = 0; cell < plan.cells.size(); ++cell) {
        if (plan.cells[cell].deterministic) continue;
        const auto pairs = pilots(store, cell);
        UntilOutcome outcome{
            .cell = cell, .trials = store.saved_trials(cell), .wanted = wanted_trials(plan.spec, pairs)};
        for (const PairPilot& pair : pairs) {
            if (!pair.pilot) {
                ++outcome.unjudged;
                continue;
            }
            const double achieved = achieved_by(*plan.spec.until, *pair.pilot, plan.spec.level, outcome.trials);
            outcome.achieved = std::max(outcome.achieved.value_or(0.0), achieved);
        }
        outcome.finding = why_not(pairs);
        if (outcome.finding == UntilFinding::reached && outcome.wanted > outcome.trials)
            outcome.finding = UntilFinding::too_many_trials;
        outcomes.push_back(outcome);
    }
    return outcomes;
}

}  // namespace ff::studies
