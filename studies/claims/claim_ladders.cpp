#include "studies/claims/claim_judgements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace ff::studies {
namespace {

/// Whether a sequence of errors falls, as far as its intervals tell.
ClaimVerdict falling(const std::vector<MeanWithError>& errors) {
    ClaimVerdict verdict = ClaimVerdict::supported;
    for (std::size_t i = 1; i < errors.size(); ++i) {
        if (errors[i].low() > errors[i - 1].high()) return ClaimVerdict::refuted;
        if (errors[i].high() >= errors[i - 1].low()) verdict = ClaimVerdict::inconclusive;
    }
    return verdict;
}

std::vector<MeanWithError> mean_sum_errors(const ClaimEvidence& evidence, const std::vector<std::size_t>& cells) {
    std::vector<MeanWithError> errors;
    for (const std::size_t cell : cells)
        errors.push_back(mean_with_error(evidence.sum_errors(cell), evidence.findings().plan.spec.level));
    return errors;
}

std::string ladder(const ClaimEvidence& evidence, const std::vector<std::size_t>& cells,
                   const std::vector<MeanWithError>& errors) {
    std::vector<std::string> rungs;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const Cell& cell = evidence.findings().plan.cells[cells[i]];
        const std::string samples = cell.deterministic ? "" : fmt::format(" × {} rays", cell.samples_per_patch);
        rungs.push_back(
            fmt::format("{} at {} patches per face{}", percent(errors[i]), cell.subdivision.per_part(), samples));
    }
    return fmt::format("Mean Σ r.e.: {}.", fmt::join(rungs, ", "));
}

}  // namespace

Judgement judge_falling(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    const auto cells = evidence.cells(claim, 0);
    if (cells.size() < 2) return not_in_study();
    const auto errors = mean_sum_errors(evidence, cells);
    return {falling(errors), ladder(evidence, cells, errors)};
}

Judgement judge_not_always_falling(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    const auto cells = evidence.cells(claim, 0);
    if (cells.size() < 2) return not_in_study();
    std::string text;
    double least = 1;
    double most = 0;
    for (std::size_t i = 1; i < cells.size(); ++i) {
        const auto coarse = evidence.sum_errors(cells[i - 1]);
        const auto fine = evidence.sum_errors(cells[i]);
        const std::size_t trials = std::min(coarse.size(), fine.size());
        std::size_t worse = 0;
        for (std::size_t t = 0; t < trials; ++t) {
            if (fine[t] > coarse[t]) ++worse;
        }
        const Share share = share_of(worse, trials, evidence.findings().plan.spec.level);
        least = std::min(least, share.interval.low);
        most = std::max(most, share.interval.high);
        text += fmt::format("From {} to {} patches per face a single run gets worse in {}. ",
                            evidence.findings().plan.cells[cells[i - 1]].subdivision.per_part(),
                            evidence.findings().plan.cells[cells[i]].subdivision.per_part(), percent(share));
    }
    const auto errors = mean_sum_errors(evidence, cells);
    text += ladder(evidence, cells, errors);
    if (falling(errors) == ClaimVerdict::supported)
        text += " So it is chance: the mean error falls with every subdivision.";
    // "Not always" wants an event that really happens: more than one run in twenty.
    return {is_above(least, most, 0.05), text};
}

}  // namespace ff::studies
