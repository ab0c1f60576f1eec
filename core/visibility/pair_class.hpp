#pragma once

#include "core/geometry/fwd.hpp"

#include <array>
#include <string_view>

namespace ff {

/// The relative position of two faces; decides which methods converge on the pair, and how fast.
enum class PairClass {
    self,      ///< the same face
    parallel,  ///< every two of their surfaces are parallel
    adjacent,  ///< some of their surfaces meet along a line, as a rule a shared edge or part of one
    other,     ///< anything else; they may still share a corner
};

/// The classes of two different faces.
inline constexpr std::array pair_classes{PairClass::parallel, PairClass::adjacent, PairClass::other};

/// "self", "parallel", "adjacent" or "other".
std::string_view name(PairClass pair_class);

/// Symmetric in the two faces. Angles below 1e-12 and gaps below 1e-12 of the surfaces' size count as none. Two faces
/// of more than 4 million pairs of surfaces are `other` without a test.
/// @pre both are indices into scene.faces
PairClass pair_class(const Scene& scene, int from_face, int to_face);

}  // namespace ff
