#pragma once

#include "studies/results/results.hpp"

#include <cstddef>
#include <set>

namespace ff::reports {

/// Cells (indices into StudyPlan::cells) in the middle of ladders of five sizes and more, which reports do not show one
/// by one: slopes and pictures of error against evaluations say more. In a study of occlusion all cells of its scenes,
/// which have a table of their own. What must be seen is never among them: lost rays,
/// a bias, a margin that is not kept, sizes that the verdict is about.
std::set<std::size_t> cells_in_between(const studies::StudyResults& results);

}  // namespace ff::reports
