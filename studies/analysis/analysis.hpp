#pragma once

#include "core/exact/known_factors.hpp"
#include "studies/analysis/class_error.hpp"
#include "studies/analysis/error_shape.hpp"
#include "studies/analysis/patch_error.hpp"
#include "studies/analysis/summary.hpp"
#include "studies/store/store.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ff::studies {

/// The evidence on bias from the trials, on all distinct pairs of a cell together. The family-wise error rate is that
/// of the whole study: each of its sampled cells gets an equal (Sidak) share of it.
struct BiasFamily {
    std::size_t pairs = 0;            ///< 30 in a box, or 15 under reciprocal completion
    std::size_t untestable = 0;       ///< pairs among them without a variance or an exact value
    std::size_t unknown = 0;          ///< untestable because there is no exact value
    std::size_t infinite = 0;         ///< untestable because the variance is infinite
    std::size_t sparse = 0;           ///< untestable because there are too few hits
    std::size_t undefined = 0;        ///< untestable because some trial gave no number
    bool few_trials = false;          ///< nothing is tested: too few trials, or no possible bias is detectable
    bool constant_and_wrong = false;  ///< some pair has the same wrong value in every trial, beyond chance
    double largest_t = 0;             ///< largest |t|, t = bias / standard error
    Quantity largest_pair;
    double adjusted_p = 1;  ///< smallest p-value, adjusted for pairs (Holm) and cells (Sidak): the family-wise verdict
    double minimum_detectable_bias = 0;  ///< on the worst pair, at the family-wise level and the study's power
    double shown_below = 0;              ///< smallest margin within which every pair is equivalent (level 1 - 2 alpha)
    std::optional<double> margin;        ///< the study's equivalence margin
    double planned_margin = 0;           ///< margin that an unbiased method would pass with the study's power
};

enum class BiasFinding { no_bias_found, biased, untestable };
enum class EquivalenceFinding { shown, refuted, inconclusive, not_asked };

/// The exact value of a quantity; empty where there is none.
/// @param known  known_factors(scene)
std::optional<double> reference_of(const Scene& scene, const KnownFactors& known, Quantity quantity);

/// Probability that an honest estimator gives one value, as wrong as this one, in every trial. Its distribution is
/// assumed unimodal on its lattice, with a mode within one step of the mean, like that of hits: then a value k steps
/// from the mean has probability at most 1 / (k + 1). Without a lattice, no value has a probability above 1/2. The
/// result is 1 where the value is as close to the exact one as the lattice allows.
double p_of_constant(double bias, std::optional<double> lattice, std::size_t trials);

BiasFinding bias_finding(const BiasFamily& family, double level);
/// Shown if every pair's interval lies inside the margin; refuted if some pair's adjusted interval lies outside.
EquivalenceFinding equivalence_finding(const BiasFamily& family, bool refuted);

/// Statistics of one cell.
struct CellFindings {
    std::size_t cell = 0;
    std::uint64_t trials = 0;  ///< saved
    std::uint64_t trials_planned = 0;
    std::uint64_t lost_rays = 0;
    std::uint64_t evaluations_per_face = 0;
    std::vector<Summary> summaries;        ///< in the order of `all_quantities`
    std::vector<ClassError> class_errors;  ///< of the classes that the scene has; empty without exact values
    std::vector<ErrorShape> shapes;        ///< of distinct pairs with enough trials that vary
    std::optional<PatchErrors> patch_errors;
    std::optional<BiasFamily> bias;  ///< empty for deterministic methods
    BiasFinding bias_finding = BiasFinding::untestable;
    EquivalenceFinding equivalence = EquivalenceFinding::not_asked;

    [[nodiscard]] const Summary& summary(Quantity quantity) const;
    /// The efficiency of `class_error`; empty where that is missing or there is no variance.
    [[nodiscard]] std::optional<double> class_rmse(PairClass pair_class) const;
    /// Null where the cell has no such pair or reference, or some trial of such a pair gave no number.
    [[nodiscard]] const ClassError* class_error(PairClass pair_class) const;
    /// Whether the estimates of some pair of the class have no variance.
    [[nodiscard]] bool has_infinite_variance(PairClass pair_class) const;
};

/// All that a study found; every report is made from it. Pure: the same store gives the same findings to the bit.
struct Findings {
    StudyPlan plan;
    bool complete = false;  ///< every planned unit is there
    std::vector<CellFindings> cells;
};

Findings analyse(const Store& store);

/// Summaries of one cell.
CellFindings analyse_cell(const Store& store, std::size_t cell);

}  // namespace ff::studies
