#pragma once

#include "studies/comparison/contests.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace ff::studies {

/// The results of a method on all scenes of a kind.
struct Choice {
    std::size_t method = 0;       ///< index into StudySpec::methods
    std::size_t entered = 0;      ///< scenes
    std::size_t best = 0;         ///< scenes where nothing is shown to be better
    double largest_handicap = 1;  ///< largest estimated ratio to the best entrant; infinite where another is exact
};

/// Which method to take for a kind of pairs, by the main contests of a study.
struct Decision {
    PairClass pair_class = PairClass::other;
    bool may_be_occluded = false;  ///< whether something may stand in between
    Equal equal = Equal::evaluations;
    std::size_t scenes = 0;
    std::vector<Choice> choices;  ///< most often best first; ties by the smaller handicap
};

/// Empty where a study has one scene.
std::vector<Decision> decide(const StudyPlan& plan, std::span<const Contest> contests, Equal equal);

/// Whether something may stand between two faces of a class, among pairs with an exact value.
bool may_be_occluded(const Scene& scene, PairClass wanted);

}  // namespace ff::studies
