#pragma once

#include "studies/comparison/contests.hpp"
#include "studies/trials/estimates.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace ff::studies {

/// A method of a run.
struct Duellist {
    const CellReader& cells;
    const Analysis& findings;
    std::size_t method = 0;  ///< index into StudySpec::methods
};

/// Two methods at equal cost on a class of pairs of a scene.
struct Bout {
    std::size_t scene = 0;  ///< index into the scenes of the first run
    PairClass pair_class = PairClass::other;
    Equal equal = Equal::evaluations;
    double budget = 0;                   ///< as Contest::budget
    std::array<std::size_t, 2> cells{};  ///< sizes that both enter with: indices into StudyPlan::cells of their runs
    std::size_t better = 0;              ///< 0 or 1: the method with the smaller value
    double ratio = 1;                    ///< of the mean square errors, or at equal error of the evaluations; 1 or more
    /// Interval of the ratio; empty where neither varies, where the better one is exact, and where an end is infinite.
    std::optional<stats::Interval> interval;
    bool is_exact = false;               ///< the better one errs by rounding alone, and the ratio means nothing
    bool is_shown = false;               ///< that it is better
    std::optional<double> times_trials;  ///< as Handicap::times_trials
    bool is_main = false;                ///< the most informative one of its scene, class and equality
};

/// The contests of two methods of one run or of two, whatever their sizes. All intervals of a scene with the same thing
/// equal hold together. Processor time is compared where both runs say that they had the same processor and build.
/// @param scenes  those with the same faces in both runs: indices into both plans
std::vector<Bout> hold_duel(const Duellist& first, const Duellist& second,
                            const std::vector<std::pair<std::size_t, std::size_t>>& scenes);

}  // namespace ff::studies
