#include "studies/claims/claims.hpp"

#include "studies/claims/claim_evidence.hpp"
#include "studies/claims/comparison.hpp"

#include <algorithm>
#include <array>

namespace ff::studies {
namespace {

/// The basis of a verdict: intervals of mean errors, or shares and ranges of single runs.
enum class Grounds { means, runs };

struct Kind {
    std::string_view name;
    Grounds grounds;
    Judgement (*judge)(const ClaimEvidence&, const PublishedClaim&);
};

constexpr std::array kinds{
    Kind{"error_falls_with_subdivision", Grounds::means, judge_falling},
    Kind{"error_falls_with_subdivision_not_always", Grounds::runs, judge_not_always_falling},
    Kind{"error_falls_with_samples", Grounds::means, judge_falling},
    Kind{"smaller_sum_error", Grounds::means, judge_smaller_sum_error},
    Kind{"smaller_error", Grounds::means, judge_smaller_error},
    Kind{"smaller_error_not_always", Grounds::runs, judge_not_always_smaller},
    Kind{"count_larger_error", Grounds::runs, judge_count},
    Kind{"uniform_error", Grounds::runs, judge_uniform},
    Kind{"nonuniform_error", Grounds::runs, judge_nonuniform},
    Kind{"no_single_best", Grounds::means, judge_division},
    Kind{"best_per_class", Grounds::means, judge_advice},
    Kind{"claimed_errors_hold", Grounds::runs, judge_claimed_errors_hold},
};

}  // namespace

std::vector<JudgedClaim> judge_claims(const CellReader& cells, const Analysis& findings,
                                      const PublishedTables& tables) {
    const auto scene = find_scene(findings.plan, tables);
    const ClaimEvidence evidence(cells, findings, tables, scene.value_or(0));
    std::vector<JudgedClaim> judged;
    for (const PublishedClaim& claim : tables.claims) {
        const auto kind = std::ranges::find(kinds, claim.kind, &Kind::name);
        Judgement judgement{ClaimVerdict::inconclusive,
                            "A claim of this kind cannot be judged by numbers of the study."};
        if (kind != kinds.end() && !scene) judgement = not_in_study();
        if (kind != kinds.end() && scene) {
            judgement = kind->grounds == Grounds::means && evidence.infinite_variance(claim)
                            ? Judgement{ClaimVerdict::inconclusive,
                                        "A method has infinite variance on pairs that touch: no interval holds for its "
                                        "mean error."}
                            : kind->judge(evidence, claim);
        }
        judged.push_back({claim, judgement.verdict, judgement.as_printed_only, judgement.evidence});
    }
    return judged;
}

}  // namespace ff::studies
