#pragma once

#include "core/exact/known_factors.hpp"
#include "studies/analysis/bias.hpp"
#include "studies/analysis/class_error.hpp"
#include "studies/analysis/summary.hpp"
#include "studies/store/store.hpp"
#include "studies/trials/estimates.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ff::studies {

/// The exact value of a quantity; empty where there is none.
/// @param known  known_factors(scene)
std::optional<double> reference_of(const Scene& scene, const KnownFactors& known, Quantity quantity);

/// Where on the faces a method's errors arise: one value for each patch.
struct PatchErrors {
    std::vector<double> rmse;  ///< root mean square error of the factors of each patch, over trials and other faces
    double at_edges = 0;       ///< root mean square over the patches along the edges of the surfaces
    double inside = 0;         ///< the same of all others; 0 where there are none
    std::size_t worst = 0;     ///< patch
};

/// Compares the patch sums in the store with the exact patch-to-face factors: direct estimates, before completion by
/// reciprocity.
/// @return empty without patch sums, trials or exact factors, and for one patch per surface
std::optional<PatchErrors> patch_errors(const Store& store, std::size_t cell);

/// Statistics of one cell.
struct CellAnalysis {
    std::size_t cell = 0;
    std::uint64_t trials = 0;  ///< number of saved trials
    std::uint64_t trials_planned = 0;
    std::uint64_t lost_rays = 0;
    std::uint64_t samples_of_pair = 0;       ///< as in CellEstimates
    std::uint64_t evaluations_per_face = 0;  ///< as in CellEstimates
    std::vector<Summary> summaries;          ///< in the order of `all_quantities`
    std::vector<ClassError> class_errors;    ///< one for each class that the scene has; empty without exact values
    std::vector<ErrorShape> shapes;          ///< one for each distinct pair with enough trials that vary
    std::optional<PatchErrors> patch_errors;
    std::optional<BiasFamily> bias;  ///< empty for deterministic methods
    BiasFinding bias_finding = BiasFinding::untestable;
    EquivalenceFinding equivalence = EquivalenceFinding::not_asked;
    /// Trials that repeat earlier ones beyond chance (stats/dependence/repeats.hpp). If there are any, nothing is
    /// tested or compared, and there are no intervals.
    std::size_t repeated_trials = 0;

    [[nodiscard]] const Summary& summary(Quantity quantity) const;
    /// The RMSE of `class_error`; empty where that is missing or the variance is infinite.
    [[nodiscard]] std::optional<double> class_rmse(PairClass pair_class) const;
    /// Null where the cell has no such pair or reference, or some trial of such a pair gave no number.
    [[nodiscard]] const ClassError* class_error(PairClass pair_class) const;
    /// Whether the estimates of some pair of the class have no variance.
    [[nodiscard]] bool has_infinite_variance(PairClass pair_class) const;
};

/// All that a study found; every report is made from it. Pure: the same store gives the same findings to the bit.
struct Analysis {
    StudyPlan plan;
    bool complete = false;  ///< every planned unit is there
    std::vector<CellAnalysis> cells;
};

Analysis analyse(const CellReader& cells);

/// The warning of a cell whose trials repeat each other; empty where they do not.
std::string repeats_in_words(const StudyPlan& plan, const CellAnalysis& found);

/// Summaries of one cell.
CellAnalysis analyse_cell(const CellReader& cells, std::size_t cell);

}  // namespace ff::studies
