#pragma once

#include "studies/analysis/analysis.hpp"

#include <cstddef>
#include <vector>

namespace ff::studies {

/// A pair of faces whose trials look as if they had no variance, although theory gives them one or is silent.
struct HeavyTail {
    std::size_t cell = 0;
    Quantity pair;
    double index = 0;  ///< of the upper tail; the variance is infinite below 2
};

/// Tests the tail of every pair that counts as having a variance (stats/tail_index.hpp), at the study's error rate over
/// all of them together. Nothing is found in cells of fewer than 200 trials: too few to see a tail.
std::vector<HeavyTail> find_heavy_tails(const Store& store, const Findings& findings);

}  // namespace ff::studies
