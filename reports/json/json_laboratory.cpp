#include "reports/json/json_records.hpp"

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

std::string_view name(studies::RateFinding finding) {
    constexpr std::array<std::string_view, 5> names{"as_expected", "slower", "faster", "no_theory", "no_slope"};
    return names.at(static_cast<std::size_t>(finding));
}

Json expected_json(const studies::Slope& slope) {
    if (!slope.expected) return nullptr;
    return {{"rate", slope.expected->rate},
            {"slowest", slope.slowest_expected},
            {"bound", slope.expected->at_least},
            {"source", slope.expected->source},
            {"because", slope.expected->because}};
}

Json class_json(const Scene& scene, const studies::ClassSlopes& found) {
    Json json{{"pair_class", ff::name(found.pair_class)},
              {"pairs", found.pairs},
              {"finding", name(found.finding)},
              {"adjusted_p", optional_json(found.adjusted_p)},
              {"slopes", {slope_json(scene, found.rmse), slope_json(scene, found.median)}}};
    Json& sizes = json["sizes"] = Json::array();
    for (const studies::ClassError& size : found.sizes) {
        const bool infinite = size.status == studies::VarianceStatus::infinite;
        sizes.push_back({{"evaluations", size.evaluations},
                         {"rmse", infinite ? Json() : Json(size.rmse)},
                         {"median_abs_error", size.median_abs_error},
                         {"bias", size.bias},
                         {"bias_interval", interval_json(size.bias_interval)},
                         {"efficiency", optional_json(size.efficiency)},
                         {"efficiency_interval", interval_json(size.efficiency_interval)}});
    }
    return json;
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
            entrants.push_back({{"method", plan.spec.methods[cell.method].name},
                                {"patches_per_face", cell.subdivision.per_part()},
                                {"samples_per_patch", samples_json(cell)},
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
                              {"apart", handicap.apart},
                              {"times_trials", optional_json(handicap.times_trials)}});
        }
        Json exact = Json::array();
        for (const std::size_t cell : contest.exact) exact.push_back(cell_label(plan, plan.cells[cell]));
        rows.push_back({{"scene", plan.scenes.name(contest.scene)},
                        {"pair_class", ff::name(contest.pair_class)},
                        {"equal", studies::name(contest.equal)},
                        {"budget", contest.budget},
                        {"exact", std::move(exact)},
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

Json slope_json(const Scene& scene, const studies::Slope& slope) {
    return {{"from_face", slope.pair ? Json(from_label(scene, *slope.pair)) : Json(nullptr)},
            {"to_face", slope.pair ? Json(to_label(scene, *slope.pair)) : Json(nullptr)},
            {"pair_class", ff::name(slope.pair_class)},
            {"statistic", studies::name(slope.statistic)},
            {"slope", optional_json(slope.slope)},
            {"interval", interval_json(slope.interval)},
            {"interval_from_fit", interval_json(slope.interval_from_fit)},
            {"lack_of_fit_p", optional_json(slope.lack_of_fit_p)},
            {"expected", expected_json(slope)},
            {"p", optional_json(slope.p)},
            {"points", slope.points}};
}

Json slopes_json(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    Json ladders = Json::array();
    for (const studies::LadderSlopes& ladder : results.slopes) {
        const Scene& scene = plan.scenes[ladder.ladder.scene];
        const bool samples = ladder.ladder.growth == studies::Growth::samples;
        Json json{{"scene", plan.scenes.name(ladder.ladder.scene)},
                  {"method", plan.spec.methods[ladder.ladder.method].name},
                  {"label", ladder.ladder.label},
                  {"growth", samples ? "samples" : "patches"},
                  {"multiplicity", "holm over all classes with an expected rate"}};
        Json& classes = json["classes"] = Json::array();
        for (const studies::ClassSlopes& found : ladder.classes) classes.push_back(class_json(scene, found));
        Json& pairs = json["pairs"] = Json::array();
        for (const studies::Slope& slope : ladder.pairs) pairs.push_back(slope_json(scene, slope));
        ladders.push_back(std::move(json));
    }
    return ladders;
}

}  // namespace ff::reports
