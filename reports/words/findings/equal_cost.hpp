#pragma once

#include "core/visibility/pair_class.hpp"
#include "studies/comparison/ranking.hpp"
#include "studies/results/results.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace ff::reports {

// Errors are ranked at the sizes that methods were run with, which need not cost the same.

/// " with 845 times fewer evaluations" of the first than of the second; empty where both have about as many.
std::string at_what_cost(const studies::Analysis& findings, const studies::Ranked& first,
                         const studies::Ranked& second);

/// What speaks against taking the best of a ranking of errors where they cost more than another, which at equal
/// evaluations is not shown to be worse: "at equal evaluations a errs less"; empty where nothing does.
std::string but_at_equal_cost(const studies::StudyResults& results, std::span<const studies::Ranked> ranked,
                              std::size_t scene, PairClass pair_class);

/// Whether the method of a cell is exact to rounding at all of its sizes.
bool is_exact_at_all_sizes(const studies::Analysis& findings, const studies::Cell& cell, PairClass pair_class);

/// The name of the method of a cell (by its index in the plan), with its size if the method is not exact at all of its
/// sizes: "b (1 × 16 points)".
std::string exact_name(const studies::Analysis& findings, std::size_t index, PairClass pair_class);

/// "On parallel pairs a and b (1 × 16 points) are exact to rounding.", with the size of a method that is not exact at
/// all of its sizes; empty where no method is.
std::string which_are_exact(const studies::StudyResults& results, std::size_t scene, PairClass pair_class);

}  // namespace ff::reports
