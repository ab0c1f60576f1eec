#pragma once

#include "core/geometry/scene.hpp"

#include <string>

namespace ff::studies {

/// How the faces of two scenes differ, in words, whatever stands between these: "2 in the first and 4 in the second".
/// Empty where factors are of the same faces.
std::string difference_of_faces(const Scene& a, const Scene& b);

}  // namespace ff::studies
