#include "studies/analysis/analysis.hpp"

#include "core/estimators/added.hpp"
#include "core/exact/exact.hpp"
#include "core/patches/patch_order.hpp"
#include "core/visibility/mirrors.hpp"
#include "core/visibility/pair_class.hpp"
#include "samplers/outside/added.hpp"
#include "stats/basics/interval.hpp"
#include "stats/dependence/repeats.hpp"
#include "stats/error_rates/power.hpp"
#include "studies/theory/known_variance.hpp"
#include "studies/trials/until.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace ff::studies {
namespace {

/// Minimum detectable bias in standard deviations of a trial; 0 where no test is possible.
double detectable_in_sigmas(const StudyPlan& plan, std::size_t pairs, std::size_t trials,
                            std::optional<std::size_t> pilot) {
    if (trials < stats::fewest_replicates) return 0;
    // After two stages the spread, and the degrees of freedom, are those of the pilot.
    const std::size_t behind_spread = std::min(trials, pilot.value_or(trials));
    const double gain = std::sqrt(static_cast<double>(behind_spread) / static_cast<double>(trials));
    return gain * stats::minimum_detectable_bias(1.0, behind_spread, {level_of_pair(plan, pairs), plan.spec.power});
}

/// Finite where it is finite for every one of these pairs.
VarianceStatus class_variance(const CellAnalysis& findings, const std::vector<Quantity>& pairs) {
    VarianceStatus worst = VarianceStatus::finite;
    for (const Quantity pair : pairs) {
        const VarianceStatus status = findings.summary(pair).variance;
        if (status == VarianceStatus::finite) continue;
        if (status == VarianceStatus::undefined) return VarianceStatus::undefined;
        if (worst != VarianceStatus::infinite) worst = status;
    }
    return worst;
}

/// Our own methods, which use all of their seeds, are not checked.
std::size_t repeated_trials(const Method& method, const CellEstimates& estimates, const std::vector<Quantity>& pairs) {
    if (samplers::find_added(method.sampler) == nullptr && find_added_estimator(method.estimator) == nullptr) return 0;
    std::vector<std::span<const double>> series;
    for (const Quantity pair : pairs) series.emplace_back(estimates.values(pair));
    return stats::repeated_trials(series);
}

/// Withdraws all results that rest on independent trials.
void withdraw_evidence(CellAnalysis& findings) {
    for (Summary& summary : findings.summaries) {
        summary.bias_se.reset();
        summary.minimum_detectable_bias.reset();
        for (auto* interval : {&summary.mean_interval, &summary.bias_interval, &summary.std_interval})
            interval->reset();
    }
    for (ClassError& error : findings.class_errors) {
        error.mean_square.reset();
        error.squared_deviation.reset();
        for (auto* interval :
             {&error.interval, &error.bias_interval, &error.variance_interval, &error.efficiency_interval})
            interval->reset();
    }
    BiasFamily untested;
    untested.pairs = untested.untestable = findings.bias->pairs;
    untested.margin = findings.bias->margin;
    findings.bias = untested;
}

bool has_no_rmse(const Summary& summary) {
    return summary.variance == VarianceStatus::infinite || summary.variance == VarianceStatus::undefined;
}

/// Sums over all saved trials of what a trial estimates for the factors from each patch to each face:
/// [patch * faces + face]; empty where none are kept.
struct PatchTotals {
    std::uint64_t trials = 0;
    std::vector<double> sum;
    std::vector<double> sum_of_squares;
};

PatchTotals patch_totals(const Store& store, std::size_t cell) {
    const Cell& planned = store.plan().cells.at(cell);
    const bool counted = estimator_info(store.plan().spec.methods[planned.method]).observes == Observes::hits;
    const auto rays = static_cast<double>(planned.samples_per_patch);
    PatchTotals totals;
    Statement query(store.database().handle(),
                    "SELECT trials, patch_hits, patch_hits_squared FROM units WHERE cell = ? ORDER BY unit");
    query.with(cell);
    while (query.step()) {
        const auto sum = query.integers(1);
        const auto squares = query.integers(2);
        if (sum.empty()) continue;
        totals.trials += static_cast<std::uint64_t>(query.integer(0));
        totals.sum.resize(sum.size());
        totals.sum_of_squares.resize(squares.size());
        for (std::size_t i = 0; i < sum.size(); ++i) {
            totals.sum[i] += counted ? static_cast<double>(sum[i]) / rays : std::bit_cast<double>(sum[i]);
            totals.sum_of_squares[i] +=
                counted ? static_cast<double>(squares[i]) / (rays * rays) : std::bit_cast<double>(squares[i]);
        }
    }
    return totals;
}

bool at_edge(const PatchPlace& place, Grid grid) {
    return std::min(place.row, place.column) == 0 || place.row == grid.rows - 1 || place.column == grid.columns - 1;
}

double root_of_mean(const std::vector<double>& squares) {
    const double sum = std::accumulate(squares.begin(), squares.end(), 0.0);
    return squares.empty() ? 0 : std::sqrt(sum / static_cast<double>(squares.size()));
}

}  // namespace

std::optional<double> reference_of(const Scene& scene, const KnownFactors& known, Quantity quantity) {
    switch (quantity.kind) {
        case QuantityKind::form_factor:
            return known.at(quantity.from - 1, quantity.to - 1);
        case QuantityKind::row_sum:
            return scene.closed ? 1.0 : known.row_sum(quantity.from - 1);
        case QuantityKind::sum_relative_error:
            break;  // its expectation is not a property of the scene
    }
    return std::nullopt;
}

const Summary& CellAnalysis::summary(Quantity quantity) const {
    return *std::ranges::find(summaries, quantity, &Summary::quantity);
}

std::optional<double> CellAnalysis::class_rmse(PairClass pair_class) const {
    const ClassError* error = class_error(pair_class);
    return error == nullptr || has_infinite_variance(pair_class) ? std::nullopt : std::optional(error->rmse);
}

const ClassError* CellAnalysis::class_error(PairClass pair_class) const {
    const auto found = std::ranges::find(class_errors, pair_class, &ClassError::pair_class);
    return found == class_errors.end() ? nullptr : &*found;
}

bool CellAnalysis::has_infinite_variance(PairClass pair_class) const {
    const ClassError* error = class_error(pair_class);
    if (error != nullptr && error->status == VarianceStatus::infinite) return true;
    return std::ranges::any_of(summaries, [&](const Summary& s) {
        return s.pair_class == pair_class && s.variance == VarianceStatus::infinite;
    });
}

CellAnalysis analyse_cell(const CellReader& cells, std::size_t cell_index) {
    const StudyPlan& plan = cells.plan();
    const Cell& cell = plan.cells[cell_index];
    const Method& method = plan.spec.methods[cell.method];
    const Scene& scene = plan.scenes[cell.scene];
    const auto loaded = cells.load(cell_index);
    const CellEstimates& estimates = *loaded;
    const KnownFactors known = known_factors(scene);
    const auto pairs = distinct_pairs(estimates.faces, method.completion);
    const std::size_t tested = std::max<std::size_t>(1, known_pairs(pairs, known).size());

    CellAnalysis findings;
    findings.cell = cell_index;
    findings.trials = estimates.trials();
    findings.trials_planned = needed_trials(cells.store(), cell_index);
    findings.lost_rays = estimates.lost_rays;
    findings.samples_of_pair = estimates.samples_of_pair;
    findings.evaluations_per_face = estimates.evaluations_per_face;
    if (estimates.trials() == 0) return findings;
    bool equal_areas = true;
    for (int face = 1; face < static_cast<int>(estimates.faces); ++face)
        equal_areas = equal_areas && face_area(scene, face) == face_area(scene, 0);
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
        request.binomial = counts_hits(plan, estimates, quantity, request.variance);
        if (counts || request.binomial) request.lattice = estimates.lattice(quantity);
        request.evaluations_per_face =
            quantity.kind == QuantityKind::sum_relative_error ? 0 : estimates.evaluations_per_face;
        request.level = plan.spec.level;
        request.detectable_bias = detectable;
        request.pair_alpha = level_of_pair(plan, tested);
        request.pilot = pilot;
        request.limits = known_limits(plan, estimates, quantity);
        request.key = derive_key(plan.spec.seed, fmt::format("summary|{}|{}|{}|{}", cell.canonical,
                                                             name(method.completion), quantity.from, quantity.to));
        findings.summaries.push_back(summarise(estimates.values(quantity), request));
    }
    for (const PairClass each : pair_classes) {
        const VarianceStatus variance =
            class_variance(findings, pairs_of_class(scene, known_pairs(pairs, known), each));
        if (variance == VarianceStatus::undefined) continue;
        if (const auto error = class_error(estimates, scene, known, pairs, each, variance, plan.spec.level,
                                           [&](Quantity pair) { return known_limits(plan, estimates, pair).unmet; }))
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
    if (std::ranges::none_of(findings.summaries, has_no_rmse))
        findings.patch_errors = patch_errors(cells.store(), cell_index);
    if (!cell.deterministic) {
        bool refuted = false;
        findings.bias = judge_bias(plan, estimates, pairs, findings.summaries, refuted);
        findings.repeated_trials = repeated_trials(method, estimates, pairs);
        if (findings.repeated_trials > 0) {
            withdraw_evidence(findings);
            refuted = false;
        }
        findings.bias_finding = bias_finding(*findings.bias, plan.spec.level);
        findings.equivalence = equivalence_finding(*findings.bias, refuted);
    }
    return findings;
}

Analysis analyse(const CellReader& cells) {
    Analysis findings;
    findings.plan = cells.plan();
    findings.complete = findings.plan.spec.until ? is_adaptively_complete(cells.store()) : cells.store().is_complete();
    for (std::size_t cell = 0; cell < findings.plan.cells.size(); ++cell) {
        findings.cells.push_back(analyse_cell(cells, cell));
        if (auto words = repeats_in_words(findings.plan, findings.cells.back()); !words.empty())
            findings.plan.warnings.push_back(std::move(words));
    }
    return findings;
}

std::string repeats_in_words(const StudyPlan& plan, const CellAnalysis& found) {
    if (found.repeated_trials == 0) return {};
    const Cell& cell = plan.cells[found.cell];
    return fmt::format(
        "method '{}' in scene '{}'{}: {} of {} trials repeat earlier ones bit for bit (real numbers never do "
        "by chance). They are no independent trials, and nothing is tested: let all bits of the seed count.",
        plan.spec.methods[cell.method].name, plan.scenes.name(cell.scene),
        cell.samples_per_patch > 0 ? fmt::format(" at {} samples", cell.samples_per_patch) : "", found.repeated_trials,
        found.trials);
}

std::optional<PatchErrors> patch_errors(const Store& store, std::size_t cell_index) {
    const Cell& cell = store.plan().cells[cell_index];
    const Scene& scene = store.plan().scenes[cell.scene];
    const std::size_t faces = scene.faces.size();
    const PatchOrder order(scene, cell.subdivision);
    const std::size_t patches = order.size();
    const PatchTotals sums = patch_totals(store, cell_index);
    if (patches == scene.surfaces.size() || sums.trials == 0 || sums.sum.size() != patches * faces) return std::nullopt;
    const auto exact = exact_patch_to_face(scene, cell.subdivision);
    if (!exact) return std::nullopt;

    PatchErrors errors;
    const auto trials = static_cast<double>(sums.trials);
    std::vector<double> edges;
    std::vector<double> inner;
    for (std::uint32_t patch = 0; patch < patches; ++patch) {
        const PatchPlace place = order.place(patch);
        const Surface& surface = scene.surfaces[place.surface];
        if (!is_of_face(surface)) {
            errors.rmse.push_back(0);
            continue;
        }
        const auto own = static_cast<std::size_t>(surface.face);
        double squares = 0;
        for (std::size_t face = 0; face < faces; ++face) {
            if (face == own) continue;
            const double truth = (*exact)(patch, static_cast<Eigen::Index>(face));
            const double mean = sums.sum[patch * faces + face] / trials;
            const double mean_square = sums.sum_of_squares[patch * faces + face] / trials;
            const double variance = sums.trials == 1 ? 0 : std::max(0.0, mean_square - mean * mean);
            squares += variance + (mean - truth) * (mean - truth);
        }
        squares /= static_cast<double>(faces - 1);
        errors.rmse.push_back(std::sqrt(squares));
        (at_edge(place, cell.subdivision.of(surface)) ? edges : inner).push_back(squares);
    }
    errors.at_edges = root_of_mean(edges);
    errors.inside = root_of_mean(inner);
    errors.worst = static_cast<std::size_t>(std::ranges::max_element(errors.rmse) - errors.rmse.begin());
    return errors;
}

}  // namespace ff::studies
