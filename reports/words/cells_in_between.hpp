#pragma once

#include "studies/results/results.hpp"

#include <cstddef>
#include <set>

namespace ff::reports {

/// Cells (indices into StudyPlan::cells) in the middle of ladders of five sizes and more, which reports do not show one
/// by one: slopes and pictures of error against evaluations tell more. In a study of occlusion, all cells of its
/// scenes, which have a table of their own. Cells that must be seen are never among them: those with lost rays, a bias
/// or a missed margin, and sizes that the verdict is about.
std::set<std::size_t> cells_in_between(const studies::StudyResults& results);

}  // namespace ff::reports
