#include "studies/results/results.hpp"

#include <algorithm>

namespace ff::studies {
namespace {

bool all_finite(const Analysis& findings) {
    return std::ranges::all_of(findings.cells, [](const CellAnalysis& cell) {
        return std::ranges::all_of(cell.summaries, [](const Summary& summary) { return summary.not_finite == 0; });
    });
}

}  // namespace

StudyResults evaluate(const Store& store, const std::atomic<bool>* stop) {
    StudyResults results;
    const CellReader cells(store);
    results.findings = analyse(cells);
    results.context = store.context();
    if (results.findings.complete && all_finite(results.findings)) {
        results.slopes = fit_slopes(cells, results.findings);
        results.occlusion = occlusion_series(cells, results.findings, results.slopes);
        results.evenness = compare_evenness_with_errors(results.findings);
        results.heavy_tails = find_heavy_tails(cells, results.findings);
        results.reductions = compare_with_random(results.findings);
        results.coverage = measure_coverage(cells);
        results.until = until_outcomes(store);
        results.contests = hold_contests(cells, results.findings);
        results.claimed_errors = judge_claimed_errors(cells);
        // A share of claims that hold is judged among independent trials.
        std::erase_if(results.claimed_errors, [&](const ClaimedErrors& claimed) {
            return claimed.promised < 1 && results.findings.cells[claimed.cell].repeated_trials > 0;
        });
        if (results.findings.plan.spec.radiosity) {
            results.radiosity = radiosity::find_consequences(store, stop);
            results.bias_orders = radiosity::bias_orders(results.findings.plan, *results.radiosity);
        }
    }
    results.variance_checks = check_variances(results.findings);
    const auto& published = results.findings.plan.spec.published;
    if (published && all_finite(results.findings)) {
        PublishedResults& compared = results.published.emplace();
        compared.tables = parse_published_tables(published->text, published->file);
        compared.comparisons = compare_with_published(cells, results.findings, compared.tables);
        compared.claims = judge_claims(cells, results.findings, compared.tables);
        compared.audit = audit::examine(compared.tables);
    }
    results.error_laws = fit_error_laws(results.findings, results.published ? &results.published->tables : nullptr);
    results.rivals = find_rivals(results.findings,
                                 results.published ? results.published->comparisons : std::vector<TableComparison>{});
    return results;
}

}  // namespace ff::studies
