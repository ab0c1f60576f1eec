#pragma once

#include "studies/plan/plan.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace ff::studies {

/// The quantity that grows along a ladder.
enum class Growth { samples, patches };

/// At least three sizes of one method on one scene that differ in one thing only.
struct Ladder {
    std::size_t scene = 0;   ///< index into StudyPlan::scenes
    std::size_t method = 0;  ///< index into StudySpec::methods
    Growth growth = Growth::samples;
    std::string label;               ///< the method's name, with what is fixed if it has several ladders
    std::vector<std::size_t> cells;  ///< in ascending order of evaluations
};

/// Reports show ladders with this many sizes by their ends.
inline constexpr std::size_t long_ladder = 5;

/// All ladders of a study, in the order of its cells. Ladders that grow by patches are those of methods that have no
/// ladder of samples.
std::vector<Ladder> find_ladders(const StudyPlan& plan);

}  // namespace ff::studies
