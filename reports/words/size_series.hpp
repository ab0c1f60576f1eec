#pragma once

#include "studies/results/results.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace ff::reports {

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

}  // namespace ff::reports
