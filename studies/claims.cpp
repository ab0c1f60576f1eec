#include "studies/claims.hpp"

#include "studies/claim_judgements.hpp"
#include "studies/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ff::studies {

Judgement not_in_study() {
    return {ClaimVerdict::inconclusive, "The study has no trials of the methods and sizes that the claim is about."};
}

std::string percent(const MeanWithError& value) {
    if (value.half_width == 0) return fmt::format("{:.3g} %", value.mean);
    const int decimals = std::max(0, 1 - static_cast<int>(std::floor(std::log10(value.half_width))));
    return fmt::format("{:.{}f} ± {:.{}f} %", value.mean, decimals, value.half_width, decimals);
}

std::string percent(const Share& share) {
    return fmt::format("{:.1f} % [{:.1f}, {:.1f}] of {} trials", 100 * share.value(), 100 * share.interval.low,
                       100 * share.interval.high, share.of);
}

namespace {

struct Kind {
    std::string_view name;
    Judgement (*judge)(const ClaimEvidence&, const PublishedClaim&);
};

constexpr std::array kinds{
    Kind{"error_falls_with_subdivision", judge_falling},
    Kind{"error_falls_with_subdivision_not_always", judge_not_always_falling},
    Kind{"error_falls_with_samples", judge_falling},
    Kind{"smaller_sum_error", judge_smaller_sum_error},
    Kind{"smaller_error", judge_smaller_error},
    Kind{"smaller_error_not_always", judge_not_always_smaller},
    Kind{"count_larger_error", judge_count},
    Kind{"uniform_error", judge_uniform},
    Kind{"nonuniform_error", judge_nonuniform},
    Kind{"no_single_best", judge_division},
    Kind{"best_per_class", judge_division},
};

}  // namespace

std::string_view name(ClaimVerdict verdict) {
    switch (verdict) {
        case ClaimVerdict::supported:
            return "supported";
        case ClaimVerdict::refuted:
            return "refuted";
        case ClaimVerdict::inconclusive:
            break;
    }
    return "inconclusive";
}

std::vector<JudgedClaim> judge_claims(const Store& store, const Findings& findings, const PublishedTables& tables) {
    const auto scene = find_scene(findings.plan, tables);
    const ClaimEvidence evidence(store, findings, tables, scene.value_or(0));
    std::vector<JudgedClaim> judged;
    for (const PublishedClaim& claim : tables.claims) {
        const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return k.name == claim.kind; });
        Judgement judgement{ClaimVerdict::inconclusive,
                            "A claim of this kind cannot be judged by numbers of the study."};
        if (kind != kinds.end()) judgement = scene ? kind->judge(evidence, claim) : not_in_study();
        judged.push_back({claim, judgement.verdict, judgement.as_printed_only, judgement.evidence});
    }
    return judged;
}

}  // namespace ff::studies
