#pragma once

#include "core/geometry/scene.hpp"

namespace ff {

/// Whether parts of each surface may lie in front of the other: if not, their exchange is 0. For curved surfaces it
/// only decides that a concave one sees itself and a convex one does not.
bool face_each_other(const Surface& a, const Surface& b);

/// Whether that holds for some pair of surfaces of two faces; true without a test where there are mirrors, or more than
/// 4 million pairs. Faces from 0.
bool face_each_other(const Scene& scene, int from_face, int to_face);

/// Whether some part of a surface of one face lies behind a flat one of the other, which it cannot see. Faces from 0.
bool are_partly_behind(const Scene& scene, int from_face, int to_face);

/// Whether a ray may lead from the radiating side of a face to that side again, straight or by way of mirrors.
bool sees_itself(const Scene& scene, int face);

/// Whether no surface has a part behind the plane of another (by more than 1e-12 of the smallest surface's size): then
/// nothing stands between any two of them. The inside of a box is convex. False where some surface is curved, and
/// without a test for more than 4096 surfaces, since the cost is quadratic.
bool is_convex(const Scene& scene);

}  // namespace ff
