#pragma once

#include "studies/analysis/analysis.hpp"

#include <cstddef>
#include <vector>

namespace ff::studies {

/// A pair of faces whose trials seem to have infinite variance, although theory says otherwise or is silent.
struct HeavyTail {
    std::size_t cell = 0;
    Quantity pair;
    double index = 0;  ///< tail index of the upper tail; the variance is infinite below 2
};

/// Tests the tail of every pair that is treated as having a variance (stats/variances/tails.hpp), at the study's
/// error rate over all of them together. Cells with fewer than 200 trials are skipped: a tail does not show in fewer.
std::vector<HeavyTail> find_heavy_tails(const CellReader& cells, const Analysis& findings);

}  // namespace ff::studies
