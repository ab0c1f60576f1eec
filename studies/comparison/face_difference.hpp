#pragma once

#include "core/geometry/scene.hpp"

#include <string>

namespace ff::studies {

/// How the faces of two scenes differ, in words, whatever stands between the faces: "2 in the first and 4 in the
/// second". Empty where the faces are the same.
std::string difference_of_faces(const Scene& a, const Scene& b);

}  // namespace ff::studies
