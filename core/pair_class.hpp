#pragma once

#include "core/scene.hpp"

#include <string_view>

namespace ff {

/// How two faces lie to each other; decides which methods converge on the pair, and how fast.
enum class PairClass {
    self,      ///< the same face
    parallel,  ///< every two of their surfaces are parallel
    adjacent,  ///< some of their surfaces share (part of) an edge
    other,
};

std::string_view name(PairClass pair_class);

PairClass pair_class(const Scene& scene, int from_face, int to_face);

}  // namespace ff
