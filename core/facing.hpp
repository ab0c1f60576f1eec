#pragma once

#include "core/scene.hpp"

namespace ff {

/// Whether some of each surface lies in front of the other: if not, nothing passes between them.
bool face_each_other(const Surface& a, const Surface& b);

/// Whether no surface has a part behind the plane of another (by more than 1e-12 of the two surfaces' size): then
/// nothing stands between any two of them. The inside of a box is convex.
bool is_convex(const Scene& scene);

}  // namespace ff
