#include "studies/diagnostics/variance_check.hpp"

#include "samplers/sampler.hpp"
#include "stats/basics/distributions.hpp"
#include "stats/error_rates/multiplicity.hpp"
#include "studies/theory/sr_distribution.hpp"

#include <algorithm>
#include <cmath>
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
    auto quantities = distinct_pairs(scene.faces.size(), method.completion);
    for (int face = 1; face <= static_cast<int>(scene.faces.size()); ++face)
        quantities.push_back({QuantityKind::row_sum, face, 0});
    for (const Quantity quantity : quantities) {
        const bool pair = quantity.kind == QuantityKind::form_factor;
        const double sigma =
            pair ? exact->pair_sigma(quantity.from - 1, quantity.to - 1) : exact->sum_sigma(quantity.from - 1);
        const auto& sampled = found.summary(quantity).std;
        if (sigma == 0 || !sampled) continue;  // closure fixes the sum
        // Chi-squared wants nearly normal counts: ten hits per trial.
        const double mean = found.summary(quantity).reference.value_or(1.0);
        if (mean * static_cast<double>(found.evaluations_per_face) < 10) continue;
        const double p = chi_squared_two_sided_p(*sampled, sigma, found.trials);
        check.quantities.push_back({quantity, sigma, *sampled, p});
        p_values.push_back(p);
    }
    if (p_values.empty()) return std::nullopt;
    const auto adjusted = stats::holm(p_values);
    check.adjusted_p = *std::min_element(adjusted.begin(), adjusted.end());
    const auto ratio = [](const VarianceComparison& c) { return c.sampled / c.exact; };
    const auto [least, most] = std::minmax_element(check.quantities.begin(), check.quantities.end(),
                                                   [&](const auto& a, const auto& b) { return ratio(a) < ratio(b); });
    check.smallest_ratio = ratio(*least);
    check.largest_ratio = ratio(*most);
    return check;
}

}  // namespace

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

}  // namespace ff::studies
