#pragma once

#include "reports/text/table.hpp"
#include "studies/comparison/run_comparison.hpp"

#include <string>

namespace ff::reports {

/// The name that the method has in both runs, or that of either.
std::string method_names(const studies::RunComparison& comparison, const studies::CellComparison& compared);

/// "cube: Sobol' rays", without the scene where there is only one.
std::string scene_and_method(const studies::RunComparison& comparison, const studies::CellComparison& compared);

/// A forest plot in characters: every ratio of RMSEs with its interval. Empty where there is none.
std::string ratio_plot(const studies::RunComparison& comparison);

/// The verdict on one method and size in words.
TableCell likeness_in_words(const studies::RunComparison& comparison, const studies::CellComparison& cell);

}  // namespace ff::reports
