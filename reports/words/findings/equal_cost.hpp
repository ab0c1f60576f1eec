#pragma once

#include "core/visibility/pair_class.hpp"
#include "studies/comparison/ranking.hpp"
#include "studies/results/results.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace ff::reports {

// Errors are ranked at the sizes that methods were run with, which need not cost the same.

/// " with 170 times fewer evaluations" of the first than of the second; empty where both have about as many.
std::string at_what_cost(const studies::Analysis& findings, const studies::Ranked& first,
                         const studies::Ranked& second);

/// What speaks against taking the best of a ranking of errors where they cost more than another, which at equal
/// evaluations is not shown to be worse: "at equal evaluations a errs less"; empty where nothing does.
std::string but_at_equal_cost(const studies::StudyResults& results, std::span<const studies::Ranked> ranked,
                              std::size_t scene, PairClass pair_class);

/// "On parallel pairs a is exact to rounding."; empty where no method is.
std::string which_are_exact(const studies::StudyResults& results, std::size_t scene, PairClass pair_class);

}  // namespace ff::reports
