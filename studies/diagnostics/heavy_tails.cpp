#include "studies/diagnostics/heavy_tails.hpp"

#include "stats/error_rates/multiplicity.hpp"
#include "stats/variances/tails.hpp"

namespace ff::studies {
namespace {

/// The tails that can be tested, with their fits.
struct Candidate {
    HeavyTail tail;
    stats::TailFit fit;
};

std::vector<Candidate> candidates(const CellReader& cells, const Analysis& findings) {
    std::vector<Candidate> found;
    for (const CellAnalysis& cell : findings.cells) {
        const auto loaded = cells.load(cell.cell);
        const CellEstimates& estimates = *loaded;
        for (const Summary& summary : cell.summaries) {
            const bool pair = summary.quantity.kind == QuantityKind::form_factor;
            if (!pair || summary.variance != VarianceStatus::finite) continue;
            const auto fit = stats::fit_tail(estimates.values(summary.quantity));
            if (fit && fit->index()) found.push_back({{cell.cell, summary.quantity, *fit->index()}, *fit});
        }
    }
    return found;
}

}  // namespace

std::vector<HeavyTail> find_heavy_tails(const CellReader& cells, const Analysis& findings) {
    const auto tested = candidates(cells, findings);
    std::vector<HeavyTail> heavy;
    if (tested.empty()) return heavy;
    const double alpha = stats::sidak_level(1 - findings.plan.spec.level, tested.size());
    for (const Candidate& candidate : tested) {
        if (stats::judge_variance(candidate.fit, alpha) == stats::VarianceHealth::infinite)
            heavy.push_back(candidate.tail);
    }
    return heavy;
}

}  // namespace ff::studies
