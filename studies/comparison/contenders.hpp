#pragma once

#include "core/visibility/pair_class.hpp"
#include "stats/means/mean_test.hpp"
#include "studies/analysis/analysis.hpp"
#include "studies/comparison/contests.hpp"
#include "studies/run/measured_costs.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace ff::studies {

/// One size of a method on a class of pairs.
struct Rung {
    std::size_t cell = 0;
    double cost = 0;        ///< evaluations or seconds of a trial
    double cost_error = 0;  ///< standard error of its logarithm
    double mean_square = 0;
    stats::Measured log_mean_square;  ///< its logarithm
    bool repeatable = false;          ///< the mean of several trials has a smaller error
    /// Bias that a trial is not shown not to have. Of a user's own code, which may have any that its trials do not
    /// show; what ffstudy provides has none.
    double bias = 0;
};

using Costs = std::vector<std::optional<MeasuredCost>>;  ///< one for each cell

/// Sizes of a method that differ in cost, by ascending cost.
using Contender = std::vector<Rung>;

/// All sizes of each method that err, or of each number of patches where those have several sizes.
std::vector<Contender> contenders(const Analysis& findings, const Costs& costs, std::size_t scene, PairClass pair_class,
                                  Equal equal);

/// The cheapest size of each method that is exact to rounding. In a few trials, hits may be as expected by chance.
std::vector<Rung> exact_sizes(const Analysis& findings, const Costs& costs, std::size_t scene, PairClass pair_class,
                              Equal equal);

}  // namespace ff::studies
