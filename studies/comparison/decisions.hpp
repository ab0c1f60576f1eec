#pragma once

#include "studies/comparison/contests.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace ff::studies {

/// The results of a method in all cases of a kind.
struct Choice {
    std::size_t method = 0;       ///< index into StudySpec::methods
    std::size_t ran = 0;          ///< cases
    std::size_t entered = 0;      ///< cases where it has a variance, and a cost in common with others
    std::size_t best = 0;         ///< cases where nothing is shown to be better
    double largest_handicap = 1;  ///< largest estimated ratio to the best entrant; infinite where another is exact
};

/// What decides which method suits a pair of faces. Surfaces that see themselves, as round ones, may occlude each
/// other.
enum class PairKind {
    parallel,           ///< polygons that see all of each other, in parallel planes
    adjacent,           ///< the same, with a common edge
    other,              ///< the same, with another position
    small,              ///< the same, with form factors below 0.02: far away or small
    occluded,           ///< polygons between which something may stand
    occluded_adjacent,  ///< the same, with a common edge
    curved,             ///< a round surface is among them
    curved_adjacent,    ///< the same, with a common edge
};

/// The kind of the pairs of a class of a scene, of those with an exact value.
PairKind pair_kind(const Scene& scene, PairClass pair_class);

/// Which method to take for a kind of pairs, by the main contests of a study.
struct Decision {
    PairKind kind = PairKind::other;
    Equal equal = Equal::evaluations;
    std::size_t cases = 0;        ///< scenes and classes of pairs
    std::vector<Choice> choices;  ///< most often best first; ties by fewer cases, then by the smaller handicap
};

/// The methods that are best in as many cases as the first; empty where none is best in any.
std::vector<std::size_t> most_often_best(const Decision& decision);

/// Empty where a study has one scene.
std::vector<Decision> decide(const StudyPlan& plan, std::span<const Contest> contests, Equal equal);

/// The same for an amount of processor time.
struct TimedDecisions {
    double seconds = 0;  ///< a power of ten
    std::vector<Decision> decisions;
};

/// By ascending time, of those that contests are held at.
std::vector<TimedDecisions> decide_by_time(const StudyPlan& plan, std::span<const Contest> contests);

}  // namespace ff::studies
