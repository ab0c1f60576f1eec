#pragma once

#include "stats/basics/interval.hpp"
#include "studies/analysis/analysis.hpp"
#include "studies/claims/claims.hpp"
#include "studies/published/published.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies {

/// Whether a claim's list of sizes contains a size; an empty list stands for every size.
template <typename Size>
bool names(const std::vector<Size>& sizes, Size size) {
    return sizes.empty() || std::find(sizes.begin(), sizes.end(), size) != sizes.end();
}

/// The evidence for claims: trials of the cells that they name.
class ClaimEvidence {
  public:
    /// @param scene  the study's scene that the tables are about
    ClaimEvidence(const CellReader& cells, const Analysis& findings, const PublishedTables& tables, std::size_t scene)
        : cells_(cells), findings_(findings), tables_(tables), scene_(scene) {}

    [[nodiscard]] const CellReader& cells() const { return cells_; }
    [[nodiscard]] const Analysis& findings() const { return findings_; }
    [[nodiscard]] double level() const { return findings_.plan.spec.level; }

    /// The cells of all methods at the claim's sizes; those without trials are left out.
    [[nodiscard]] std::vector<std::size_t> cells(const PublishedClaim& claim) const;

    /// The cells of the claim's method number `method`, by patches, then samples.
    [[nodiscard]] std::vector<std::size_t> cells(const PublishedClaim& claim, std::size_t method) const;

    /// Whether one of the claim's methods has infinite variance on one of its pairs, so that no interval holds for the
    /// mean error.
    [[nodiscard]] bool infinite_variance(const PublishedClaim& claim) const;

    /// Sum of relative errors of the row sums in every trial, percent.
    [[nodiscard]] std::vector<double> sum_errors(std::size_t cell) const;

    /// Relative errors of one trial, percent, by pair; a deterministic cell repeats its only trial.
    [[nodiscard]] std::vector<double> pair_errors(std::size_t cell, std::size_t trial,
                                                  const std::vector<Quantity>& pairs) const;

    /// Pairs with from < to of a class ("parallel", "adjacent", "all").
    [[nodiscard]] std::vector<Quantity> pairs(std::string_view pair_class) const;

    /// The errors that the publication prints for these pairs of the claim's method number `method` at the claim's
    /// sizes, percent; empty where it does not print all of them.
    [[nodiscard]] std::vector<double> printed_errors(const PublishedClaim& claim, std::size_t method,
                                                     const std::vector<Quantity>& pairs) const;

  private:
    const CellReader& cells_;
    const Analysis& findings_;
    const PublishedTables& tables_;
    std::size_t scene_;
};

/// The frequency of an event among independent trials, with its Clopper-Pearson interval.
struct Share {
    std::size_t count = 0;
    std::size_t of = 0;
    stats::Interval interval;
    [[nodiscard]] double value() const { return static_cast<double>(count) / static_cast<double>(of); }
};
Share share_of(std::size_t count, std::size_t of, double level);

/// Mean with the longer side of its interval (stats/means/mean_test.hpp); infinite where the values are too few or too
/// skewed for one, 0 for a deterministic value.
struct MeanWithError {
    double mean = 0;
    double half_width = 0;
    [[nodiscard]] double low() const { return mean - half_width; }
    [[nodiscard]] double high() const { return mean + half_width; }
};
MeanWithError mean_with_error(const std::vector<double>& values, double level);

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

// Sizes of one method, and two methods by their mean errors (studies/claims/claim_comparisons.cpp).
Judgement judge_falling(const ClaimEvidence& evidence, const PublishedClaim& claim);
/// Holds where single runs often show a larger error at the finer size by chance, whatever the mean does.
Judgement judge_not_always_falling(const ClaimEvidence& evidence, const PublishedClaim& claim);
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
