#pragma once

#include "studies/results/results.hpp"

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace ff::reports {

/// Cells (indices into StudyPlan::cells) in the middle of ladders of five sizes and more, which reports do not show one
/// by one: slopes and pictures of error against evaluations tell more. In a study of occlusion, all cells of its
/// scenes, which have a table of their own. Cells that must be seen are never among them: those with lost rays, a bias
/// or a missed margin, and sizes that the verdict is about.
std::set<std::size_t> cells_in_between(const studies::StudyResults& results);

/// A method at one size on a class of pairs.
struct SizePoint {
    const studies::CellAnalysis* found = nullptr;
    double error = 0;  ///< RMSE of a run; without a variance, the median absolute error
    bool is_median = false;
};

/// A method's sizes on one class of pairs, by ascending number of evaluations, and its ladders.
struct SizeSeries {
    std::string method;
    std::vector<SizePoint> points;
    std::vector<const studies::ClassSlopes*> ladders;
};

/// Every method of a scene that has an error on this class of pairs, in the order of the study. Errors at the level of
/// rounding are left out.
std::vector<SizeSeries> size_series(const studies::StudyResults& results, std::size_t scene, PairClass pair_class);

/// The methods that are exact to rounding on this class of pairs at some size, in the order of the study.
std::vector<std::string> exact_methods(const studies::StudyResults& results, std::size_t scene, PairClass pair_class);

/// The cells of series (indices into StudyPlan::cells), either the deterministic or the sampled ones: the single error
/// of a deterministic method may be small by luck, so the two are not compared.
std::vector<std::size_t> cells_of(const studies::StudyPlan& plan, const std::vector<SizeSeries>& all,
                                  bool deterministic);

/// The sampled methods with the smallest error at the number of evaluations that most of them have in common:
/// "Smallest error at 4096 evaluations per face: sobol or lattice." Empty where they have none.
std::string least_errors_in_common(const studies::StudyResults& results, std::size_t scene, PairClass pair_class);

}  // namespace ff::reports
