#pragma once

#include "stats/means/mean_test.hpp"
#include "stats/shares/share_test.hpp"
#include "studies/verdicts/gate.hpp"
#include "studies/verdicts/gate_result.hpp"
#include "studies/verdicts/reported/reported_quantity.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ff::studies::gates {

/// The effect in one bin of another program's report. A million of them are judged per second, so intervals are
/// computed only for the worst.
struct BinEffect {
    double value = 0;    ///< a difference, or a ratio
    double error = 0;    ///< standard error of a difference, > 0; approximate for shares, 0 for ratios
    double freedom = 0;  ///< degrees of freedom of `error`, or of a ratio's numerator; may be infinite; 0 where unknown
    double freedom_below = 0;  ///< degrees of freedom of a ratio's denominator; may be infinite
    Band band;
    std::uint32_t name = 0;  ///< number of the bin, chosen by the caller
};

/// Kinds of effects: differences of means are judged by Student's t, of shares by binomial tails, ratios of standard
/// deviations and of variances (efficiencies) by F.
enum class EffectScale { difference, difference_of_shares, ratio_of_deviations, ratio_of_variances };

/// A share and what it is compared with.
struct SharePair {
    stats::Proportion counts;
    stats::ShareReference reference;
};

/// The bins of one gate.
struct BinEffects {
    EffectScale scale = EffectScale::difference;
    std::vector<BinEffect> bins;
    std::vector<SharePair> shares;  ///< one for each bin, for differences of shares only
    /// One for each bin, for differences that rest on the spread between runs: these are judged by the rule for means,
    /// which allows for skewness. Otherwise empty.
    std::vector<stats::MeanEvidence> means = {};
    std::optional<double> together;  ///< p-value of all bins by their covariance; empty where they are independent

    [[nodiscard]] bool are_differences() const {
        return scale == EffectScale::difference || scale == EffectScale::difference_of_shares;
    }
};

/// The p-value of "the effect lies in the band", for the bin of this index: twice that of the nearer end, 1 inside.
double p_value(const BinEffects& effects, std::size_t index);

/// Both intervals of one bin.
Measurement measure_bin(const BinEffects& effects, std::size_t index, const Levels& levels);

/// One verdict for all bins. Fail: some bin (by Holm), or all bins together (by a global test), lie outside the band at
/// `alpha`. Pass: every bin's passing interval lies inside (an intersection-union test).
struct BinsVerdict {
    Verdict verdict = Verdict::inconclusive;
    double p = 1;                    ///< p-value of all bins together
    std::size_t rejected = 0;        ///< bins that lie outside by Holm
    std::size_t undecided = 0;       ///< bins that are neither inside nor outside
    std::vector<std::size_t> worst;  ///< indices of bins, the worst first, at most `most_named`
};
inline constexpr std::size_t most_named = 100;

/// @param alpha  of this gate, for all its bins    @pre at least one bin
BinsVerdict judge_bins(const BinEffects& effects, Combination combine, double alpha, double pass_alpha);

/// Counts standardised differences value / error in steps of half a standard error from -8 to 8; values beyond are
/// counted in the first and the last step.
inline constexpr double score_step = 0.5;
inline constexpr double largest_score = 8;
std::vector<std::uint64_t> count_scores(const std::vector<BinEffect>& bins);

/// Root mean square of the standardised differences: 1 where errors are right and nothing differs.
double rms_score(const std::vector<BinEffect>& bins);

}  // namespace ff::studies::gates
