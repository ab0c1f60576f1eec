#pragma once

#include "core/geometry/scene.hpp"

namespace ff {

/// Whether single precision may fail to resolve what rays meet in a scene, so that they have to be traced in double
/// precision: where a face is narrower (its area by the diagonal of its box) than 2^-9 of the scene's largest
/// coordinate; where flat surfaces lie over each other within 2^-18 of it, at an angle below 2^-4; or where a curved
/// surface and another come as near as 2^-7 to each other, nearly parallel there. Surfaces that merely share an edge or
/// a rim at a wider angle do not count: rounding misjudges only a strip of 2^-24.
/// @pre the scene is placed (core/geometry/placement.hpp)
bool has_fine_detail(const Scene& scene);

}  // namespace ff
