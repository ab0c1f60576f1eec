#include "reports/pictures/pictures.hpp"
#include "reports/pictures/ranking_rows.hpp"
#include "reports/text/labels.hpp"
#include "reports/words/answer.hpp"
#include "reports/words/coverage_words.hpp"
#include "studies/analysis/configuration_estimates.hpp"
#include "studies/comparison/decisions.hpp"
#include "studies/comparison/ranking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace ff::reports {
namespace {

using studies::Ranked;
using studies::StudyResults;

constexpr std::array all_classes{PairClass::parallel, PairClass::adjacent, PairClass::other};

/// For each class of pairs of each scene.
template <class Add>
void for_each_class(const StudyResults& results, RankingRows& rows, const Add& add) {
    for (std::size_t scene = 0; scene < results.findings.plan.scenes.size(); ++scene) {
        for (const PairClass pair_class : all_classes) {
            if (!rows.full()) add(scene, pair_class);
        }
    }
}

void add_slopes(const StudyResults& results, RankingRows& rows) {
    const studies::StudyPlan& plan = results.findings.plan;
    for_each_class(results, rows, [&](std::size_t scene, PairClass pair_class) {
        const auto ranked = studies::rank_slopes(results.slopes, scene, pair_class, plan.spec.level);
        if (ranked.slopes.empty()) return;
        rows.heading(heading_of(plan, scene, pair_class) + (ranked.of_median ? " (median error)" : ""));
        for (const Ranked& each : ranked.slopes) {
            const studies::LadderSlopes& ladder = results.slopes[each.index];
            const auto found = std::find_if(ladder.classes.begin(), ladder.classes.end(),
                                            [&](const auto& of) { return of.pair_class == pair_class; });
            const studies::Slope& slope = ranked.of_median ? found->median : found->rmse;
            rows.add({ladder.ladder.label, plan.spec.methods[ladder.ladder.method].name, "", each.value, each.interval,
                      slope.expected ? std::optional(slope.slowest_expected) : std::nullopt,
                      letter(ranked.slopes, each)});
        }
    });
}

void add_errors(const StudyResults& results, RankingRows& rows) {
    const studies::StudyPlan& plan = results.findings.plan;
    const auto tables = results.published ? results.published->comparisons : std::vector<studies::TableComparison>();
    for_each_class(results, rows, [&](std::size_t scene, PairClass pair_class) {
        const auto ranked = studies::rank_errors(results.findings,
                                                 studies::compared_cells(results.findings, scene, tables), pair_class);
        if (ranked.empty()) return;
        rows.heading(heading_of(plan, scene, pair_class));
        for (const Ranked& each : ranked) {
            const studies::Cell& cell = plan.cells[each.index];
            const std::string& method = plan.spec.methods[cell.method].name;
            const bool exact = each.value < studies::rounding_error;
            rows.add({method, method, size_label(plan, cell), exact ? std::nullopt : std::optional(each.value),
                      each.interval, std::nullopt, letter(ranked, each)});
        }
    });
}

void add_variances(const StudyResults& results, RankingRows& rows) {
    const studies::StudyPlan& plan = results.findings.plan;
    std::set<std::pair<std::size_t, PairClass>> seen;
    for (const studies::VarianceReduction& first : results.reductions) {
        if (!seen.emplace(first.random_cell, first.pair_class).second || rows.full()) continue;
        const studies::Cell& random = plan.cells[first.random_cell];
        rows.heading(fmt::format("{}, {}", heading_of(plan, random.scene, first.pair_class), size_label(plan, random)));
        const auto ranked =
            studies::rank_reductions(results.findings, results.reductions, first.random_cell, first.pair_class);
        for (const Ranked& each : ranked) {
            const std::string& method = plan.spec.methods[plan.cells[each.index].method].name;
            rows.add({method, method, size_label(plan, plan.cells[each.index]), each.value, each.interval, 1.0,
                      letter(ranked, each)});
        }
    }
}

/// The least and the most of each rule and number of replicates, over rows whose variance is finite.
void add_coverage(const StudyResults& results, RankingRows& rows) {
    std::set<studies::IntervalRule> seen;
    for (const studies::Coverage& first : results.coverage) {
        if (!seen.insert(first.rule).second) continue;
        rows.heading(std::string(rule_in_words(first.rule)));
        for (const std::uint64_t replicates : results.findings.plan.spec.coverage) {
            const studies::Coverage* least = nullptr;
            for (const studies::Coverage& row : results.coverage) {
                const bool finite = !results.findings.cells[row.cell].has_infinite_variance(row.pair_class);
                if (row.rule != first.rule || row.replicates != replicates || !finite) continue;
                if (least == nullptr || row.share() < least->share()) least = &row;
            }
            if (least == nullptr) continue;
            const studies::StudyPlan& plan = results.findings.plan;
            rows.add({fmt::format("R = {}", replicates), plan.spec.methods[plan.cells[least->cell].method].name,
                      size_label(plan, plan.cells[least->cell]), least->share(), least->actual, plan.spec.level,
                      least->short_of_nominal ? "short" : ""});
        }
    }
}

/// The estimate furthest off in each configuration.
void add_configurations(const StudyResults& results, RankingRows& rows) {
    const studies::StudyPlan& plan = results.findings.plan;
    const auto estimates = studies::configuration_estimates(results.findings);
    std::set<std::string_view> seen;
    for (const auto& first : estimates) {
        if (!seen.insert(first.configuration->name).second) continue;
        const studies::ConfigurationEstimate* worst = nullptr;
        for (const auto& row : estimates) {
            if (row.configuration != first.configuration || !row.standard_errors || !row.interval) continue;
            if (worst == nullptr || std::abs(*row.standard_errors) > std::abs(*worst->standard_errors)) worst = &row;
        }
        if (worst == nullptr) continue;
        const studies::Cell& cell = plan.cells[worst->found->cell];
        if (rows.rows() == 0) rows.heading("furthest estimate of each");
        const bool biased = worst->found->bias_finding == studies::BiasFinding::biased;
        rows.add({std::string(first.configuration->name), plan.spec.methods[cell.method].name, size_label(plan, cell),
                  worst->standard_errors, std::nullopt, 0.0, biased ? "biased" : ""});
    }
}

/// The best methods on each kind of pairs, by the share of scenes.
void add_choices(const StudyResults& results, RankingRows& rows) {
    constexpr std::size_t most_methods = 5;
    const studies::StudyPlan& plan = results.findings.plan;
    for (const studies::Decision& decision : studies::decide(plan, results.contests, studies::Equal::evaluations)) {
        if (decision.choices.empty() || rows.full()) continue;
        rows.heading(decision.may_be_occluded ? fmt::format("{}, maybe occluded", name(decision.pair_class))
                                              : kind_of_pairs(decision.pair_class, false));
        for (std::size_t i = 0; i < std::min(most_methods, decision.choices.size()); ++i) {
            const studies::Choice& choice = decision.choices[i];
            const std::string& method = plan.spec.methods[choice.method].name;
            rows.add({method, method, "", static_cast<double>(choice.best) / static_cast<double>(choice.entered),
                      std::nullopt, std::nullopt, fmt::format("{} of {}", choice.best, choice.entered)});
        }
    }
}

/// What is told about each kind of ranking.
RankingText told(Subject subject, const StudyResults& results) {
    const double level = results.findings.plan.spec.level;
    const std::string bars = fmt::format("Bars: {:g} % intervals.", 100 * level);
    const std::string groups = fmt::format(" {}", letters_in_words(level));
    RankingText text{"answer", "", "", "", {}, false};
    text.description = answer(results).text;
    switch (subject) {
        case Subject::rates:
            text.title = "Convergence rates, steepest first.";
            text.axis = "slope of ln(error) on ln(evaluations)";
            text.finding = bars + " Grey ticks: what theory expects at least." + groups;
            return text;
        case Subject::variances:
            text.title = "Variance reduction, largest first.";
            text.axis = "variance of random points / variance";
            text.finding = bars + " Grey ticks: no reduction." + groups;
            text.log = true;
            return text;
        case Subject::coverage:
            text.title = "Least coverage of each rule with R replicates.";
            text.axis = "share of intervals that contain the exact value";
            text.finding =
                bars + " Grey ticks: what the intervals promise. Colour and symbol: the method with least coverage.";
            text.isolates = false;
            return text;
        case Subject::choice:
            text.title = "The methods that are best in the most scenes.";
            text.axis = "share of scenes where nothing is shown to be better";
            text.finding = "At equal evaluations, of the scenes that a method can do.";
            return text;
        case Subject::configurations:
            text.title = "The estimate furthest from its exact value.";
            text.axis = "deviation in standard errors";
            text.finding =
                "Grey ticks: the exact value. Colour and symbol: the method with the largest deviation, which is "
                "shown.";
            return text;
        case Subject::light:
        case Subject::occlusion:
        case Subject::publication:
        case Subject::errors:
            break;
    }
    text.title = "Error of each method, smallest first.";
    text.axis = "RMSE of a run";
    text.finding = bars + groups;
    text.log = true;
    return text;
}

}  // namespace

std::optional<Picture> lead_picture(const StudyResults& results, const MethodChoice& methods) {
    const Subject subject = subject_of(results);
    RankingRows rows(methods);
    switch (subject) {
        case Subject::light:
            if (const auto group = radiosity_pictures(results); group && !group->pictures.empty())
                return group->pictures.front();
            return std::nullopt;
        case Subject::occlusion:
            return occlusion_pictures(results, methods).front();
        case Subject::coverage:
        case Subject::configurations:
            if (!methods.names.empty()) return std::nullopt;  // its rows are about all of them
            subject == Subject::coverage ? add_coverage(results, rows) : add_configurations(results, rows);
            break;
        case Subject::choice:
            add_choices(results, rows);
            break;
        case Subject::rates:
            add_slopes(results, rows);
            break;
        case Subject::variances:
            add_variances(results, rows);
            break;
        case Subject::publication:
        case Subject::errors:
            add_errors(results, rows);
            break;
    }
    if (rows.rows() < 2) return std::nullopt;  // one number needs no picture
    Picture picture = ranking_picture(results, told(subject, results), methods, rows);
    if (subject == Subject::rates) {
        picture.name = "convergence rates";
        picture.alternatives = errors_at_sizes(results, methods);
    }
    return picture;
}

}  // namespace ff::reports
