#include "studies/analysis/analysis.hpp"

#include "core/exact/known_factors.hpp"
#include "core/visibility/pair_class.hpp"
#include "stats/bias_test.hpp"
#include "stats/interval.hpp"
#include "stats/moments.hpp"
#include "stats/multiplicity.hpp"
#include "stats/power.hpp"
#include "stats/two_stage.hpp"
#include "studies/theory/known_variance.hpp"
#include "studies/trials/until.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace ff::studies {
namespace {

/// Cells whose bias is tested; at least 1.
std::size_t sampled_cells(const StudyPlan& plan) {
    const auto sampled =
        std::count_if(plan.cells.begin(), plan.cells.end(), [](const Cell& cell) { return !cell.deterministic; });
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, sampled));
}

/// Level of the test of one pair: the study's error rate, shared among its cells, then among the pairs of a cell.
double level_of_pair(const StudyPlan& plan, std::size_t pairs) {
    return stats::sidak_level(stats::sidak_level(1.0 - plan.spec.level, sampled_cells(plan)), pairs);
}

/// Minimum detectable bias in standard deviations of a trial; 0 where no test is possible.
double detectable_in_sigmas(const StudyPlan& plan, std::size_t pairs, std::size_t trials,
                            std::optional<std::size_t> pilot) {
    if (trials < stats::fewest_replicates) return 0;
    // After two stages the spread, and the degrees of freedom, are those of the pilot.
    const std::size_t behind_spread = std::min(trials, pilot.value_or(trials));
    const double gain = std::sqrt(static_cast<double>(behind_spread) / static_cast<double>(trials));
    return gain * stats::minimum_detectable_bias(1.0, behind_spread, {level_of_pair(plan, pairs), plan.spec.power});
}

/// @param tested  how many of the pairs have an exact value; at least 1
BiasFamily judge_family(const CellEstimates& estimates, const std::vector<Quantity>& pairs, std::size_t tested,
                        const CellFindings& findings, const StudyPlan& plan, bool& refuted) {
    const StudySpec& spec = plan.spec;
    BiasFamily family;
    family.pairs = pairs.size();
    family.margin = spec.equivalence_margin;
    const double alpha = 1.0 - spec.level;
    const std::size_t cells = sampled_cells(plan);
    const double pair_alpha = level_of_pair(plan, tested);
    if (estimates.trials() < stats::fewest_replicates) {
        family.few_trials = true;
        family.untestable = family.pairs;
        return family;
    }
    std::vector<double> p_values;
    std::vector<std::size_t> constants;  // of p_values: those of pairs with one value in every trial
    double largest_std = 0;
    for (const Quantity pair : pairs) {
        const Summary& summary = findings.summary(pair);
        const bool testable = summary.variance == VarianceStatus::finite && summary.reference;
        const std::span<const double> values = estimates.values(pair);
        // Values that are no numbers have no moments either.
        const auto moments =
            stats::moments_of(values.first(testable ? values.size() : 0), summary.reference.value_or(0.0));
        const auto pilot =
            testable && spec.until ? stats::pilot_of(values, spec.until->pilot) : std::optional<stats::Pilot>();
        const auto test = testable ? stats::test_bias(moments, pilot) : std::nullopt;
        if (!test) {
            ++family.untestable;
            if (!summary.reference) {
                ++family.unknown;
                continue;
            }
            if (summary.variance == VarianceStatus::infinite) ++family.infinite;
            if (summary.variance == VarianceStatus::sparse) ++family.sparse;
            if (summary.variance == VarianceStatus::undefined) ++family.undefined;
            const bool varies = summary.std && *summary.std > 0;
            if (summary.variance != VarianceStatus::finite || varies || !summary.bias || estimates.trials() < 2)
                continue;
            // Trials that all give one wrong value: their random numbers are no replicates, or the method is wrong.
            const double p = p_of_constant(*summary.bias, estimates.lattice(pair), estimates.trials());
            if (p == 1) continue;
            constants.push_back(p_values.size());
            p_values.push_back(p);
            continue;
        }
        p_values.push_back(test->p);
        largest_std = std::max(largest_std, summary.std.value_or(0.0));
        if (std::abs(test->t) > family.largest_t) {
            family.largest_t = std::abs(test->t);
            family.largest_pair = pair;
        }
        family.minimum_detectable_bias =
            std::max(family.minimum_detectable_bias, summary.minimum_detectable_bias.value_or(1.0));
        const double margin = spec.equivalence_margin.value_or(1.0);
        if (const auto equivalence = stats::test_equivalence(moments, pilot, margin, alpha)) {
            const double reach = std::max(std::abs(equivalence->interval.low), std::abs(equivalence->interval.high));
            family.shown_below = std::max(family.shown_below, reach);
        }
        if (const auto strict = stats::test_equivalence(moments, pilot, margin, pair_alpha / 2))
            refuted = refuted || strict->different;
    }
    if (p_values.empty()) return family;
    const auto adjusted = stats::holm(p_values);
    const double of_cell = *std::min_element(adjusted.begin(), adjusted.end());
    const auto over_cells = [cells](double p) { return -std::expm1(static_cast<double>(cells) * std::log1p(-p)); };
    family.adjusted_p = over_cells(of_cell);
    family.constant_and_wrong =
        std::any_of(constants.begin(), constants.end(), [&](std::size_t i) { return over_cells(adjusted[i]) < alpha; });
    // A form factor lies between 0 and 1: a larger bias is none that could be.
    const bool nothing_found = family.adjusted_p >= alpha && family.untestable < family.pairs;
    if (nothing_found && family.minimum_detectable_bias >= 1) {
        family.few_trials = true;
        family.untestable = family.pairs;
        family.minimum_detectable_bias = 0;
    }
    if (largest_std > 0 && estimates.trials() >= 2) {
        family.planned_margin = stats::equivalence_margin(largest_std, estimates.trials(), {alpha, spec.power}, tested);
    }
    return family;
}

/// Finite where it is so for every one of these pairs.
VarianceStatus class_variance(const CellFindings& findings, const std::vector<Quantity>& pairs) {
    VarianceStatus worst = VarianceStatus::finite;
    for (const Quantity pair : pairs) {
        const VarianceStatus status = findings.summary(pair).variance;
        if (status == VarianceStatus::finite) continue;
        if (status == VarianceStatus::undefined) return VarianceStatus::undefined;
        if (worst != VarianceStatus::infinite) worst = status;
    }
    return worst;
}

bool has_no_rmse(const Summary& summary) {
    return summary.variance == VarianceStatus::infinite || summary.variance == VarianceStatus::undefined;
}

}  // namespace

std::optional<double> reference_of(const Scene& scene, const KnownFactors& known, Quantity quantity) {
    switch (quantity.kind) {
        case QuantityKind::form_factor:
            return known.at(quantity.from - 1, quantity.to - 1);
        case QuantityKind::row_sum:
            return scene.closed ? 1.0 : known.row_sum(quantity.from - 1);
        case QuantityKind::sum_relative_error:
            break;  // its expectation is no property of the scene
    }
    return std::nullopt;
}

double p_of_constant(double bias, std::optional<double> lattice, std::size_t trials) {
    constexpr double rounding = 1e-12;
    const double error = std::abs(bias);
    if (error <= lattice.value_or(0.0) + rounding) return 1;
    const double steps = lattice ? std::floor(error / *lattice) : 1;
    return std::pow(1 / (steps + 1), static_cast<double>(trials - 1));
}

BiasFinding bias_finding(const BiasFamily& family, double level) {
    if (family.constant_and_wrong) return BiasFinding::biased;
    if (family.few_trials || family.untestable == family.pairs) return BiasFinding::untestable;
    return family.adjusted_p < 1.0 - level ? BiasFinding::biased : BiasFinding::no_bias_found;
}

EquivalenceFinding equivalence_finding(const BiasFamily& family, bool refuted) {
    if (!family.margin) return EquivalenceFinding::not_asked;
    if (refuted && !family.few_trials) return EquivalenceFinding::refuted;
    return family.untestable == 0 && family.shown_below < *family.margin ? EquivalenceFinding::shown
                                                                         : EquivalenceFinding::inconclusive;
}

const Summary& CellFindings::summary(Quantity quantity) const {
    return *std::find_if(summaries.begin(), summaries.end(), [&](const Summary& s) { return s.quantity == quantity; });
}

std::optional<double> CellFindings::class_rmse(PairClass pair_class) const {
    const ClassError* error = class_error(pair_class);
    return error == nullptr || error->status == VarianceStatus::infinite ? std::nullopt : std::optional(error->rmse);
}

const ClassError* CellFindings::class_error(PairClass pair_class) const {
    const auto found = std::find_if(class_errors.begin(), class_errors.end(),
                                    [&](const ClassError& error) { return error.pair_class == pair_class; });
    return found == class_errors.end() ? nullptr : &*found;
}

bool CellFindings::has_infinite_variance(PairClass pair_class) const {
    return std::any_of(summaries.begin(), summaries.end(), [&](const Summary& s) {
        return s.pair_class == pair_class && s.variance == VarianceStatus::infinite;
    });
}

CellFindings analyse_cell(const Store& store, std::size_t cell_index) {
    const StudyPlan& plan = store.plan();
    const Cell& cell = plan.cells[cell_index];
    const Method& method = plan.spec.methods[cell.method];
    const Scene& scene = plan.scenes[cell.scene];
    const CellEstimates estimates = load_estimates(store, cell_index);
    const KnownFactors known = known_factors(scene);
    const auto pairs = distinct_pairs(estimates.faces, method.completion);
    const std::size_t tested = std::max<std::size_t>(1, known_pairs(pairs, known).size());

    CellFindings findings;
    findings.cell = cell_index;
    findings.trials = estimates.trials();
    findings.trials_planned = needed_trials(store, cell_index);
    findings.lost_rays = estimates.lost_rays;
    findings.evaluations_per_face = estimates.evaluations_per_face;
    if (estimates.trials() == 0) return findings;
    const bool equal_areas = [&] {
        for (std::size_t face = 1; face < estimates.faces; ++face) {
            if (face_area(scene, static_cast<int>(face)) != face_area(scene, 0)) return false;
        }
        return true;
    }();
    const std::optional<std::size_t> pilot = plan.spec.until ? std::optional(plan.spec.until->pilot) : std::nullopt;
    const double detectable = detectable_in_sigmas(plan, tested, estimates.trials(), pilot);
    for (const Quantity quantity : all_quantities(estimates)) {
        SummaryRequest request;
        request.quantity = quantity;
        if (quantity.kind == QuantityKind::form_factor)
            request.pair_class = pair_class(scene, quantity.from - 1, quantity.to - 1);
        request.variance = known_variance(method, scene, quantity);
        request.reference = reference_of(scene, known, quantity);
        if (request.variance == VarianceStatus::finite &&
            too_few_hits(estimates.lattice(quantity), request.reference, estimates.trials())) {
            request.variance = VarianceStatus::sparse;
        }
        const bool counts = quantity.kind != QuantityKind::sum_relative_error &&
                            (equal_areas || method.completion == Completion::direct);
        if (counts) request.lattice = estimates.lattice(quantity);
        request.evaluations_per_face =
            quantity.kind == QuantityKind::sum_relative_error ? 0 : estimates.evaluations_per_face;
        request.level = plan.spec.level;
        request.detectable_bias = detectable;
        request.pilot = pilot;
        request.key = derive_key(plan.spec.seed, fmt::format("summary|{}|{}|{}|{}", cell.canonical,
                                                             name(method.completion), quantity.from, quantity.to));
        findings.summaries.push_back(summarise(estimates.values(quantity), request));
    }
    for (const PairClass each : {PairClass::parallel, PairClass::adjacent, PairClass::other}) {
        const VarianceStatus variance =
            class_variance(findings, pairs_of_class(scene, known_pairs(pairs, known), each));
        if (variance == VarianceStatus::undefined) continue;
        if (const auto error = class_error(estimates, scene, known, pairs, each, variance, plan.spec.level))
            findings.class_errors.push_back(*error);
    }
    for (const Quantity pair : pairs) {
        const Summary& summary = findings.summary(pair);
        const auto lattice = equal_areas ? estimates.lattice(pair) : std::nullopt;
        if (!summary.reference || summary.variance == VarianceStatus::undefined) continue;
        if (auto shape = error_shape(estimates.values(pair), *summary.reference, lattice)) {
            shape->quantity = pair;
            findings.shapes.push_back(std::move(*shape));
        }
    }
    if (std::none_of(findings.summaries.begin(), findings.summaries.end(), has_no_rmse))
        findings.patch_errors = patch_errors(store, cell_index);
    if (!cell.deterministic) {
        bool refuted = false;
        findings.bias = judge_family(estimates, pairs, tested, findings, plan, refuted);
        findings.bias_finding = bias_finding(*findings.bias, plan.spec.level);
        findings.equivalence = equivalence_finding(*findings.bias, refuted);
    }
    return findings;
}

Findings analyse(const Store& store) {
    Findings findings;
    findings.plan = store.plan();
    findings.complete = store.plan().spec.until ? is_adaptively_complete(store) : store.is_complete();
    for (std::size_t cell = 0; cell < findings.plan.cells.size(); ++cell)
        findings.cells.push_back(analyse_cell(store, cell));
    return findings;
}

}  // namespace ff::studies
