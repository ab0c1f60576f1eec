#pragma once

#include "studies/claims/claim_evidence.hpp"
#include "studies/claims/claims.hpp"

#include <string>

namespace ff::studies {

/// A verdict and the numbers behind it, in sentences.
struct Judgement {
    ClaimVerdict verdict = ClaimVerdict::inconclusive;
    std::string evidence;
    bool as_printed_only = false;  ///< see JudgedClaim
};

/// Judges the claim that a value known to lie between `low` and `high` is above a number.
inline ClaimVerdict is_above(double low, double high, double number) {
    return low > number ? ClaimVerdict::supported : high < number ? ClaimVerdict::refuted : ClaimVerdict::inconclusive;
}

/// The verdict where the study has no trials for a claim.
Judgement not_in_study();

/// Relative errors below this, in percent, are rounding of the form factors.
inline constexpr double rounding_percent = 1e-10;

/// "0.87 ± 0.02 %", as many decimals as the error warrants; "exact to rounding" below `rounding_percent`.
std::string percent(const MeanWithError& value);
/// "92.0 % [90.1, 93.6] of 1000 trials", with the Clopper-Pearson interval.
std::string percent(const Share& share);

// Sizes of one method (studies/claims/claim_ladders.cpp).
Judgement judge_falling(const ClaimEvidence& evidence, const PublishedClaim& claim);
/// Holds where single runs often show a larger error at the finer size by chance, whatever the mean does.
Judgement judge_not_always_falling(const ClaimEvidence& evidence, const PublishedClaim& claim);

// Two methods, by their mean errors (studies/claims/claim_comparisons.cpp).
Judgement judge_smaller_sum_error(const ClaimEvidence& evidence, const PublishedClaim& claim);
Judgement judge_smaller_error(const ClaimEvidence& evidence, const PublishedClaim& claim);
/// First method better on parallel pairs and second on adjacent ones.
Judgement judge_division(const ClaimEvidence& evidence, const PublishedClaim& claim);
/// The same, as advice: the evidence begins with whether it holds between the two methods, and as a rule for
/// deterministic and sampled ones.
Judgement judge_advice(const ClaimEvidence& evidence, const PublishedClaim& claim);

// Errors by pair within a run (studies/claims/claim_pairs.cpp).
Judgement judge_count(const ClaimEvidence& evidence, const PublishedClaim& claim);
Judgement judge_not_always_smaller(const ClaimEvidence& evidence, const PublishedClaim& claim);
Judgement judge_uniform(const ClaimEvidence& evidence, const PublishedClaim& claim);
Judgement judge_nonuniform(const ClaimEvidence& evidence, const PublishedClaim& claim);
/// Judges a method by the errors that it claims for itself.
Judgement judge_claimed_errors_hold(const ClaimEvidence& evidence, const PublishedClaim& claim);

}  // namespace ff::studies
