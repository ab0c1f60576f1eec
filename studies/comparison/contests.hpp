#pragma once

#include "core/visibility/pair_class.hpp"
#include "stats/basics/interval.hpp"
#include "studies/analysis/analysis.hpp"
#include "studies/plan/plan.hpp"
#include "studies/readers/names.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace ff::studies {

/// The quantity that is equal for the methods in a comparison.
enum class Equal {
    evaluations,     ///< evaluations in a trial, over all faces
    processor_time,  ///< processor time, as measured
    error,           ///< a target RMSE
};

template <>
inline constexpr auto names_of<Equal> = name_table(Named{Equal::evaluations, "evaluations"},
                                                   Named{Equal::processor_time, "processor_time"},
                                                   Named{Equal::error, "error"});

/// A method at a budget: the largest of its sizes that the budget allows, repeated until the budget is used up. For a
/// target error, the evaluations needed: by log-log interpolation between two sizes, beyond the largest by
/// repetition.
struct Entrant {
    std::size_t cell = 0;   ///< index into StudyPlan::cells
    double repeats = 1;     ///< runs whose mean is taken; 1 for deterministic and biased methods
    double value = 0;       ///< mean square error, or evaluations at equal error
    std::size_t group = 0;  ///< from 0; see groups_apart (studies/comparison/ranking.hpp)
};

/// How much worse one entrant is than another.
struct Handicap {
    std::size_t better = 0;  ///< index into Contest::entrants; the worse one comes later there
    std::size_t worse = 0;
    double ratio = 1;                         ///< worse value / better value, at least 1
    std::optional<stats::Interval> interval;  ///< empty where neither varies, and where an end would be infinite
    bool apart = false;                       ///< the ratio is shown to be above 1
    /// How many times the trials would show that, with the study's power, if the ratio is as measured; empty where it
    /// is shown, where nothing varies, at equal processor time, and beyond a million.
    std::optional<double> times_trials = std::nullopt;
};

/// Methods of a study on a class of pairs of a scene, at one budget: an entrant, and another or an exact one. Intervals
/// hold together for all pairs of entrants, budgets and classes of a scene (Bonferroni), so that being the best of
/// many is paid for.
struct Contest {
    std::size_t scene = 0;
    PairClass pair_class = PairClass::other;
    Equal equal = Equal::evaluations;
    double budget = 0;              ///< evaluations, seconds, or an RMSE
    std::vector<Entrant> entrants;  ///< best first
    std::vector<Handicap> handicaps;
    /// Cells of methods that the budget makes exact to rounding, the cheapest of each. They are better than all
    /// entrants, by no ratio that means anything, and the groups of entrants then begin at 1.
    std::vector<std::size_t> exact = {};
};

/// Budgets are those of the method with the most sizes, plus one that all methods can use. Closed forms, unrandomised
/// point sets (whose single error may be luck), and sizes without a variance or with few trials are left out. Contests
/// at equal processor time need measured costs, and are also held at powers of ten of seconds. In the order of scenes,
/// classes, what is equal, and budgets, ascending. Methods that share their random numbers (they differ in completion
/// only) are compared trial by trial.
std::vector<Contest> hold_contests(const CellReader& cells, const Analysis& findings);

/// The least power of ten of seconds that is not below a time. @pre positive
double round_time_from(double seconds);

/// The most informative contest of a scene and class: among those with the most entrants, the one with the largest
/// budget or the smallest error.
std::vector<const Contest*> main_contests(std::span<const Contest> contests, Equal equal);

}  // namespace ff::studies
