#pragma once

#include "studies/analysis/analysis.hpp"
#include "studies/published/published.hpp"
#include "studies/readers/names.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace ff::studies {

enum class ClaimVerdict {
    supported,
    as_printed_only,  ///< supported by the printed figures, but not by this study's own for the same method
    refuted,
    inconclusive,
};

template <>
inline constexpr auto names_of<ClaimVerdict> = name_table(Named{ClaimVerdict::supported, "supported"},
                                                          Named{ClaimVerdict::as_printed_only, "only as printed"},
                                                          Named{ClaimVerdict::refuted, "refuted"},
                                                          Named{ClaimVerdict::inconclusive, "inconclusive"});

/// A published claim, judged by the trials of the study.
struct JudgedClaim {
    PublishedClaim claim;
    ClaimVerdict verdict = ClaimVerdict::inconclusive;
    bool as_printed_only = false;  ///< the verdict rests on printed figures; with this study's own it differs
    std::string evidence;          ///< the numbers behind the verdict, with their uncertainty, in sentences
};

/// Kinds of claims that can be judged; a claim of another kind is inconclusive and says so.
///
/// error_falls_with_subdivision, error_falls_with_subdivision_not_always, error_falls_with_samples,
/// smaller_sum_error, smaller_error, smaller_error_not_always, count_larger_error, uniform_error, nonuniform_error,
/// no_single_best, best_per_class, claimed_errors_hold
std::vector<JudgedClaim> judge_claims(const CellReader& cells, const Analysis& findings, const PublishedTables& tables);

}  // namespace ff::studies
