#pragma once

#include "core/geometry/fwd.hpp"

#include <cstdint>

namespace ff {

/// Allowance for rounding, relative to what is compared: a patch, a surface or a pair of surfaces. Gaps below this
/// share of its size count as none, and so do angles below it.
inline constexpr double rounding_room = 1e-12;

/// The end of a pair of surfaces, `from` or `to`, that a side of a body has to face for what it hides to count: sides
/// that turn their back to it hide nothing that no other side of the body hides.
enum class FacedEnd : std::uint8_t { either, from, to };

/// A surface that may stand between two others.
struct Blocker {
    const Surface* surface = nullptr;
    FacedEnd faces = FacedEnd::either;

    Blocker(const Surface* blocker, FacedEnd end = FacedEnd::either)  // NOLINT(google-explicit-constructor): a surface
        : surface(blocker), faces(end) {}                             // alone hides whatever it faces
};

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
