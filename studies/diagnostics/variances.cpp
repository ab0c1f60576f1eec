#include "studies/diagnostics/variances.hpp"

#include "samplers/sampler.hpp"
#include "stats/basics/distributions.hpp"
#include "stats/error_rates/multiplicity.hpp"
#include "stats/variances/tails.hpp"
#include "studies/theory/sr_distribution.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace ff::studies {
namespace {

double chi_squared_two_sided_p(double sampled, double exact, std::size_t trials) {
    const auto freedom = static_cast<double>(trials - 1);
    const double ratio = sampled / exact;
    const double upper = stats::chi_squared_tail(freedom * ratio * ratio, freedom);
    return std::min(1.0, 2.0 * std::min(upper, 1.0 - upper));
}

/// Adjusted for the quantities of this cell only. Empty where the exact variance is not known, and below two trials.
std::optional<VarianceCheck> check_cell(const Analysis& findings, std::size_t cell_index) {
    const Cell& cell = findings.plan.cells[cell_index];
    const Method& method = findings.plan.spec.methods[cell.method];
    const CellAnalysis& found = findings.cells[cell_index];
    const bool known =
        estimator_info(method).observes == Observes::hits && samplers::find(method.sampler).info.independent();
    if (!known || found.trials < 2) return std::nullopt;
    const Scene& scene = findings.plan.scenes[cell.scene];
    const auto exact =
        sr_distribution(scene, cell.subdivision, static_cast<double>(cell.samples_per_patch), method.completion);
    if (!exact) return std::nullopt;

    VarianceCheck check;
    check.cell = cell_index;
    std::vector<double> p_values;
    auto quantities = distinct_pairs(findings.plan.scenes.faces(cell.scene).size(), method.completion);
    for (int face = 1; face <= static_cast<int>(findings.plan.scenes.faces(cell.scene).size()); ++face)
        quantities.push_back({QuantityKind::row_sum, face, 0});
    for (const Quantity quantity : quantities) {
        const bool pair = quantity.kind == QuantityKind::form_factor;
        const double sigma =
            pair ? exact->pair_sigma(quantity.from - 1, quantity.to - 1) : exact->sum_sigma(quantity.from - 1);
        const auto& sampled = found.summary(quantity).std;
        if (sigma == 0 || !sampled) continue;  // closure fixes the sum
        // Chi-squared wants nearly normal counts: ten hits per trial.
        const double mean = found.summary(quantity).reference.value_or(1.0);
        if (mean * static_cast<double>(found.samples_of_pair) < 10) continue;
        const double p = chi_squared_two_sided_p(*sampled, sigma, found.trials);
        check.quantities.push_back({quantity, sigma, *sampled, p});
        p_values.push_back(p);
    }
    if (p_values.empty()) return std::nullopt;
    const auto adjusted = stats::holm(p_values);
    check.adjusted_p = *std::ranges::min_element(adjusted);
    const auto ratio = [](const VarianceComparison& c) { return c.sampled / c.exact; };
    const auto [least, most] = std::ranges::minmax_element(check.quantities, {}, ratio);
    check.smallest_ratio = ratio(*least);
    check.largest_ratio = ratio(*most);
    return check;
}

/// The cell of random points that differs from this one in the sampler and the allocation of its points only.
std::optional<std::size_t> counterpart(const StudyPlan& plan, const Cell& cell) {
    const Method& method = plan.spec.methods[cell.method];
    const auto found = std::ranges::find_if(plan.cells, [&](const Cell& other) {
        const Method& candidate = plan.spec.methods[other.method];
        return candidate.sampler == samplers::yardstick().name && other.scene == cell.scene &&
               candidate.estimator == method.estimator && candidate.completion == method.completion &&
               other.subdivision.m == cell.subdivision.m && other.samples_per_patch == cell.samples_per_patch;
    });
    if (method.sampler == samplers::yardstick().name || found == plan.cells.end()) return std::nullopt;
    return static_cast<std::size_t>(found - plan.cells.begin());
}

}  // namespace

std::vector<HeavyTail> find_heavy_tails(const CellReader& cells, const Analysis& findings) {
    std::vector<HeavyTail> tested;
    std::vector<stats::TailFit> fits;
    for (const CellAnalysis& cell : findings.cells) {
        const auto estimates = cells.load(cell.cell);
        for (const Summary& summary : cell.summaries) {
            const bool pair = summary.quantity.kind == QuantityKind::form_factor;
            if (!pair || summary.variance != VarianceStatus::finite) continue;
            const auto fit = stats::fit_tail(estimates->values(summary.quantity));
            if (!fit || !fit->index()) continue;
            tested.push_back({cell.cell, summary.quantity, *fit->index()});
            fits.push_back(*fit);
        }
    }
    if (tested.empty()) return {};
    const double alpha = stats::sidak_level(1 - findings.plan.spec.level, tested.size());
    std::vector<HeavyTail> heavy;
    for (std::size_t i = 0; i < tested.size(); ++i) {
        if (stats::judge_variance(fits[i], alpha) == stats::VarianceHealth::infinite) heavy.push_back(tested[i]);
    }
    return heavy;
}

std::vector<VarianceCheck> check_variances(const Analysis& findings) {
    std::vector<VarianceCheck> checks;
    std::vector<double> p_values;
    for (std::size_t cell = 0; cell < findings.cells.size(); ++cell) {
        auto check = check_cell(findings, cell);
        if (!check) continue;
        p_values.push_back(check->adjusted_p);
        checks.push_back(std::move(*check));
    }
    const auto adjusted = stats::sidak(p_values);
    for (std::size_t i = 0; i < checks.size(); ++i) checks[i].adjusted_p = adjusted[i];
    return checks;
}

std::vector<VarianceReduction> compare_with_random(const Analysis& findings) {
    const StudyPlan& plan = findings.plan;
    std::vector<VarianceReduction> reductions;
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        const auto random = counterpart(plan, plan.cells[i]);
        if (plan.cells[i].deterministic || !random) continue;
        for (const PairClass pair_class : pair_classes) {
            const ClassError* ours = findings.cells[i].class_error(pair_class);
            const ClassError* theirs = findings.cells[*random].class_error(pair_class);
            if (ours == nullptr || theirs == nullptr || !ours->squared_deviation || !theirs->squared_deviation)
                continue;
            const auto interval = ratio_interval(log_variance(*ours), log_variance(*theirs), plan.spec.level);
            if (!interval->is_finite() || interval->low == 0) continue;
            reductions.push_back({i, *random, pair_class, *theirs->variance / *ours->variance, *interval});
        }
    }
    return reductions;
}

}  // namespace ff::studies
