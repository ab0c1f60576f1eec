#pragma once

#include "stats/means/mean_test.hpp"
#include "studies/analysis/summary.hpp"
#include "studies/trials/estimates.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace ff::studies {

/// The evidence on bias from the trials, on all distinct pairs of a cell together. The family-wise error rate is that
/// of the whole study: each of its sampled cells gets an equal (Sidak) share of it.
struct BiasFamily {
    std::size_t pairs = 0;              ///< 30 in a box, or 15 under reciprocal completion
    std::size_t untestable = 0;         ///< pairs among them without a variance or an exact value
    std::size_t no_exact_value = 0;     ///< untestable because there is no exact value
    std::size_t infinite_variance = 0;  ///< untestable because the variance is infinite
    std::size_t too_few_hits = 0;       ///< untestable because there are too few hits
    std::size_t too_skewed = 0;         ///< untestable because so few trials, so skewed, show no bias of any size
    std::size_t not_finite = 0;         ///< untestable because some trial gave no number
    bool few_trials = false;            ///< nothing is tested: too few trials, or no possible bias is detectable
    bool constant_and_wrong = false;    ///< some pair has the same wrong value in every trial, beyond chance
    bool constant = false;  ///< some pair has the same wrong value in every trial, whether or not chance explains it
    double largest_t = 0;   ///< largest |t|, t = bias / standard error
    Quantity largest_pair;
    double adjusted_p = 1;  ///< smallest p-value, adjusted for pairs (Holm) and cells (Sidak): the family-wise verdict
    double student_p = 1;   ///< the same if no value were skewed
    bool heavy_tails = false;     ///< a difference counts for nothing, because of the tails of the trials
    bool may_be_unmet = false;    ///< jumps that no evaluation has met may make the difference on the largest pair
    bool others_explain = false;  ///< trials of other pairs are so skewed that they would show a difference too
    /// A value that would explain the difference on the largest pair if trials had missed it; empty where it is known
    /// to be impossible.
    std::optional<stats::UnseenValue> unseen;
    /// That of the worst pair, at the family-wise level and the study's power; empty where no pair can be tested.
    std::optional<double> minimum_detectable_bias;
    double shown_below = 0;        ///< smallest margin within which every pair is equivalent (level 1 - 2 alpha)
    std::optional<double> margin;  ///< the study's equivalence margin
    /// The value nearest to the mean that would put some pair outside the margin if all trials had missed it; empty
    /// where bounds of the values, and their law within these, are known.
    std::optional<stats::UnseenValue> unseen_beyond_margin;
    double planned_margin = 0;  ///< margin that an unbiased method would pass with the study's power
};

enum class BiasFinding {
    no_bias_found,
    biased,
    inconclusive,  ///< a difference that skewness of the trials may explain
    untestable,
};
enum class EquivalenceFinding { shown, refuted, inconclusive, not_asked };

/// Probability that an honest estimator gives one value, as wrong as this one, in every trial. Its distribution is
/// assumed unimodal on its lattice, with a mode within one step of the mean, like that of hits: then a value k steps
/// from the mean has probability at most 1 / (k + 1). Without a lattice, no value has a probability above 1/2. The
/// result is 1 where the value is as close to the exact one as the lattice allows.
double p_of_constant(double bias, std::optional<double> lattice, std::size_t trials);

/// Bound of the probability that all trials have one value, this one, for any law of values from 0 to `largest` whose
/// mean is `reference`: 1 where nothing bounds them.
double p_of_any_constant(double value, double reference, double largest, std::size_t trials);

BiasFinding bias_finding(const BiasFamily& family, double level);
/// Shown if every pair's interval lies inside the margin; refuted if some pair's adjusted interval lies outside.
EquivalenceFinding equivalence_finding(const BiasFamily& family, bool refuted);

/// Level of the test of one pair: the study's error rate, shared among its sampled cells, then among the `tested` pairs
/// of a cell.
double level_of_pair(const StudyPlan& plan, std::size_t tested);

/// Whether the mean of a pair is judged by its hits: where their law is known, and where they are too few for any other
/// rule. This does not apply where the number of trials follows from the trials themselves.
bool counts_hits(const StudyPlan& plan, const CellEstimates& estimates, Quantity pair, VarianceStatus variance);

/// Tests the distinct pairs of a sampled cell together.
/// @param summaries  of all quantities of the cell
/// @param refuted    whether some pair is shown to lie outside the study's margin
BiasFamily judge_bias(const StudyPlan& plan, const CellEstimates& estimates, std::span<const Quantity> pairs,
                      std::span<const Summary> summaries, bool& refuted);

}  // namespace ff::studies
