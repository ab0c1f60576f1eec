#pragma once

#include "studies/comparison/ranking.hpp"
#include "studies/results/results.hpp"

#include <cstddef>
#include <string>

namespace ff::reports {

/// The printed and the computed errors of a cell on a class of pairs.
struct PrintedErrors {
    std::size_t cell = 0;
    PairClass pair_class = PairClass::other;
    std::size_t figures = 0;  ///< printed form factors; without any, all errors are 0
    double printed = 0;       ///< mean relative error
    double ours = 0;          ///< the same, of the mean over trials
    double printed_rms = 0;   ///< root mean square of printed - exact
    bool differs = false;     ///< they differ by more than printing explains
};

/// @pre results.published
PrintedErrors printed_errors(const studies::StudyResults& results, std::size_t cell, PairClass pair_class);

/// "; in print 1.3", how many times the error of the second is that of the first where a deterministic
/// method has the errors of its printed figures; empty where these are what the method gives.
std::string as_printed(const studies::StudyResults& results, const studies::Ranked& first,
                       const studies::Ranked& second, PairClass pair_class);

}  // namespace ff::reports
