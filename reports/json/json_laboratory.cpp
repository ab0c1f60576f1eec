#include "reports/json/json_laboratory.hpp"

#include "reports/text/labels.hpp"

#include <array>
#include <utility>

namespace ff::reports {
namespace {

std::string_view name(studies::UntilFinding finding) {
    constexpr std::array<std::string_view, 5> names{"reached", "too_many_trials", "infinite_variance", "too_few_hits",
                                                    "no_spread"};
    return names.at(static_cast<std::size_t>(finding));
}

}  // namespace

Json until_json(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    if (!plan.spec.until) return nullptr;
    Json outcomes = Json::array();
    for (const studies::UntilOutcome& outcome : results.until) {
        outcomes.push_back({{"cell", cell_label(plan, plan.cells[outcome.cell])},
                            {"finding", name(outcome.finding)},
                            {"trials", outcome.trials},
                            {"wanted", outcome.wanted},
                            {"achieved", optional_json(outcome.achieved)},
                            {"unjudged", outcome.unjudged}});
    }
    return {{"goal", studies::name(plan.spec.until->goal)},
            {"target", plan.spec.until->target},
            {"pilot", plan.spec.until->pilot},
            {"rule", "stein_two_stage"},
            {"outcomes", std::move(outcomes)}};
}

Json heavy_tails_json(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    Json rows = Json::array();
    for (const studies::HeavyTail& tail : results.heavy_tails) {
        const studies::Cell& cell = plan.cells[tail.cell];
        rows.push_back({{"cell", cell_label(plan, cell)},
                        {"pair", quantity_label(plan.scenes[cell.scene], tail.pair)},
                        {"index", tail.index}});
    }
    return rows;
}

Json coverage_json(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    Json rows = Json::array();
    for (const studies::Coverage& row : results.coverage) {
        rows.push_back({{"cell", cell_label(plan, plan.cells[row.cell])},
                        {"pair_class", ff::name(row.pair_class)},
                        {"interval_method", studies::name(row.interval_method)},
                        {"replicates", row.replicates},
                        {"mean_trials", row.mean_trials},
                        {"intervals", row.intervals},
                        {"covered", row.covered},
                        {"coverage", row.share()},
                        {"coverage_interval", interval_json(row.coverage_interval)},
                        {"short_of_nominal", row.short_of_nominal}});
    }
    return rows;
}

Json reductions_json(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    Json rows = Json::array();
    for (const studies::VarianceReduction& reduction : results.reductions) {
        rows.push_back({{"cell", cell_label(plan, plan.cells[reduction.cell])},
                        {"random_cell", cell_label(plan, plan.cells[reduction.random_cell])},
                        {"pair_class", ff::name(reduction.pair_class)},
                        {"factor", reduction.factor},
                        {"interval", interval_json(reduction.interval)}});
    }
    return rows;
}

Json contests_json(const studies::StudyResults& results, Timed timed) {
    const studies::StudyPlan& plan = results.findings.plan;
    Json rows = Json::array();
    for (const studies::Contest& contest : results.contests) {
        if ((contest.equal == studies::Equal::processor_time) != (timed == Timed::yes)) continue;
        Json entrants = Json::array();
        for (const studies::Entrant& entrant : contest.entrants) {
            const studies::Cell& cell = plan.cells[entrant.cell];
            entrants.push_back(
                {{"method", plan.spec.methods[cell.method].name},
                 {"patches_per_face", cell.subdivision.per_part()},
                 {"samples_per_patch", cell.samples_per_patch == 0 ? Json(nullptr) : Json(cell.samples_per_patch)},
                 {"repeats", entrant.repeats},
                 {"value", entrant.value},
                 {"group", entrant.group + 1}});
        }
        Json ratios = Json::array();
        for (const studies::Handicap& handicap : contest.handicaps) {
            ratios.push_back({{"better", handicap.better},
                              {"worse", handicap.worse},
                              {"ratio", handicap.ratio},
                              {"interval", interval_json(handicap.interval)},
                              {"apart", handicap.apart}});
        }
        rows.push_back({{"scene", plan.scenes[contest.scene].name},
                        {"pair_class", ff::name(contest.pair_class)},
                        {"equal", studies::name(contest.equal)},
                        {"budget", contest.budget},
                        {"entrants", std::move(entrants)},
                        {"ratios", std::move(ratios)}});
    }
    return rows;
}

Json claimed_errors_json(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    Json rows = Json::array();
    for (const studies::ClaimedErrors& row : results.claimed_errors) {
        const studies::Cell& cell = plan.cells[row.cell];
        rows.push_back({{"cell", cell_label(plan, cell)},
                        {"pair_class", ff::name(row.pair_class)},
                        {"claimant", studies::name(row.claimant)},
                        {"promised", row.promised},
                        {"claims", row.claims},
                        {"held", row.held},
                        {"worst_pair", quantity_label(plan.scenes[cell.scene], row.worst_pair)},
                        {"worst_held", row.worst_held},
                        {"worst_share_interval", interval_json(row.worst_share_interval)},
                        // Ratios are infinite where the claimed error is 0.
                        {"median_ratio", finite_json(row.median_ratio)},
                        {"largest_ratio", finite_json(row.largest_ratio)},
                        {"finding", row.finding == studies::ClaimedErrorFinding::fails ? "fails" : "not_refuted"}});
    }
    return rows;
}

}  // namespace ff::reports
