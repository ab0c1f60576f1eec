#pragma once

#include "core/geometry/scene.hpp"

namespace ff {

/// Whether some of each surface may lie in front of the other: if not, nothing passes between them. Of a curved surface
/// it is only known that a hollow one sees itself and one that bulges does not.
bool face_each_other(const Surface& a, const Surface& b);

/// Whether some surface of one face and one of the other do; true without looking where there are mirrors, or more than
/// 4 million pairs of them. Faces from 0.
bool face_each_other(const Scene& scene, int from_face, int to_face);

/// Whether a ray may lead from the radiating side of a face to that side again, straight or by way of mirrors.
bool sees_itself(const Scene& scene, int face);

/// Whether no surface has a part behind the plane of another (by more than 1e-12 of the smallest surface's size):
/// then nothing stands between any two of them. The inside of a box is convex. False where some surface is curved, and
/// of more than 4096 surfaces without looking: it takes the square of their number.
bool is_convex(const Scene& scene);

}  // namespace ff
