#include "studies/claims/claim_judgements.hpp"
#include "studies/diagnostics/claimed_errors.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::studies {

Judgement judge_claimed_errors_hold(const ClaimEvidence& evidence, const PublishedClaim& claim) {
    const auto cells = evidence.cells(claim, 0);
    std::uint64_t claims = 0;
    std::uint64_t held = 0;
    double largest = 0;
    for (const ClaimedErrors& found : judge_claimed_errors(evidence.store())) {
        const bool in_question =
            claim.pair_class.empty() || claim.pair_class == "all" || claim.pair_class == name(found.pair_class);
        if (!in_question || found.claimant == Claimant::one_run ||
            std::find(cells.begin(), cells.end(), found.cell) == cells.end())
            continue;
        claims += found.claims;
        held += found.held;
        largest = std::max(largest, found.largest_ratio);
    }
    if (claims == 0) return not_in_study();
    const std::string evidence_text = fmt::format(
        "{} of {} factors were off by no more than was claimed of them; the largest error was {:.2g} times "
        "as large as claimed.",
        held, claims, largest);
    return {held == claims ? ClaimVerdict::supported : ClaimVerdict::refuted, evidence_text};
}

}  // namespace ff::studies
