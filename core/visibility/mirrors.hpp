#pragma once

#include "core/geometry/scene.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ff {

/// The face number of perfect mirrors, which reflect rays.
inline constexpr int mirror_face = -2;

/// Whether a surface belongs to a face of its scene. The others are mirrors or obstacles.
inline bool is_of_face(const Surface& surface) {
    return surface.face >= 0;
}

/// The surfaces of a scene that are mirrors.
std::vector<std::uint32_t> mirrors(const Scene& scene);

/// The scene with some of its faces as perfect mirrors. A mirror is no longer a face: the others keep their order,
/// and light from one reaches another directly or by way of mirrors. @see [baranoski1999] section 2.2,
/// [sillion1989]
/// @throws UserError where there is no such face, it is curved, or no other face is left
Scene with_mirrors(Scene scene, std::span<const std::string> faces);

/// The mirror image of a surface. @pre parallelograms
Surface reflected(const Surface& surface, const Surface& mirror);

/// A surface and its images by one or more mirrors, itself first. A box and its images together form a box again, so
/// that a straight line to an image passes through the mirrors.
/// @return the surface alone where there is no mirror; empty where there are infinitely many images (opposite mirrors),
/// or some places cannot see them (a scene with mirrors that is not a box)
std::optional<std::vector<Surface>> images(const Scene& scene, const Surface& surface);

}  // namespace ff
