#pragma once

#include "core/geometry/scene.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ff {

/// The face of surfaces that are perfect mirrors: rays go on from them, reflected.
inline constexpr int mirror_face = -2;

/// Whether a surface belongs to a face of its scene. Others are mirrors or stand in the way.
inline bool is_of_face(const Surface& surface) {
    return surface.face >= 0;
}

/// The surfaces of a scene that are mirrors.
std::vector<std::uint32_t> mirrors(const Scene& scene);

/// The scene with some of its faces as perfect mirrors. A mirror is a face no more: the others keep their order, and
/// what leaves one of them reaches another straight or by way of mirrors. @see [baranoski1999] section 2.2,
/// [sillion1989]
/// @throws UserError where there is no such face, where it is curved, and where no other is left
Scene with_mirrors(Scene scene, std::span<const std::string> faces);

/// What a surface looks like in a mirror. @pre parallelograms
Surface reflected(const Surface& surface, const Surface& mirror);

/// The places from which a surface receives: itself, then its images, by way of one or more mirrors. A box and its
/// images together are a box again, so that a straight line to an image passes through the mirrors.
/// @return itself alone where there is no mirror; empty where images are without end (opposite mirrors), or hidden from
/// some places (a scene with mirrors that is no box)
std::optional<std::vector<Surface>> images(const Scene& scene, const Surface& surface);

}  // namespace ff
