#pragma once

#include "core/visibility/pair_class.hpp"
#include "stats/basics/interval.hpp"
#include "studies/analysis/analysis.hpp"

#include <cstddef>
#include <vector>

namespace ff::studies {

/// The factor by which a cell's variance is smaller than with as many independent random points, on all pairs of a
/// class together.
struct VarianceReduction {
    std::size_t cell = 0;
    std::size_t random_cell = 0;  ///< the cell with sampler "random" and the same scene, estimator, completion and size
    PairClass pair_class = PairClass::other;
    double factor = 1;
    stats::Interval interval;
};

/// One for each cell and class that has a variance with an interval, and a random counterpart, in the order of cells.
/// Pure.
std::vector<VarianceReduction> compare_with_random(const Analysis& findings);

}  // namespace ff::studies
