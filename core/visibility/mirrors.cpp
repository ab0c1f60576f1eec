#include "core/visibility/mirrors.hpp"

#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/nearest_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace ff {
namespace {

/// @throws UserError
int face_to_mirror(const Scene& scene, const std::string& label) {
    const auto found = std::find(scene.faces.begin(), scene.faces.end(), label);
    if (found != scene.faces.end()) return static_cast<int>(found - scene.faces.begin());
    const std::vector<std::string_view> known(scene.faces.begin(), scene.faces.end());
    throw UserError("mirrors: scene '{}' has no face '{}'. {}Its faces are {}.", scene.name, excerpt(label),
                    did_you_mean(label, known), fmt::join(scene.faces, ", "));
}

}  // namespace

std::vector<std::uint32_t> mirrors(const Scene& scene) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < scene.surfaces.size(); ++i) {
        if (scene.surfaces[i].face == mirror_face) found.push_back(i);
    }
    return found;
}

Scene with_mirrors(Scene scene, std::span<const std::string> faces) {
    if (faces.empty()) return scene;
    std::vector<bool> is_mirror(scene.faces.size());
    for (const std::string& label : faces) is_mirror[static_cast<std::size_t>(face_to_mirror(scene, label))] = true;
    std::vector<int> number(scene.faces.size(), mirror_face);
    std::vector<std::string> labels;
    for (std::size_t face = 0; face < number.size(); ++face) {
        if (is_mirror[face]) continue;
        number[face] = static_cast<int>(labels.size());
        labels.push_back(scene.faces[face]);
    }
    if (labels.empty()) {
        throw UserError(
            "mirrors: every face of scene '{}' is one (no face is left to send or receive light). Leave one out.",
            scene.name);
    }
    for (Surface& surface : scene.surfaces) {
        if (!is_of_face(surface)) continue;
        const auto face = static_cast<std::size_t>(surface.face);
        surface.face = number[face];
        if (is_mirror[face] && !is_flat(surface.shape)) {
            throw UserError(
                "mirrors: face '{}' of scene '{}' is curved (images of it are distorted: only flat faces can be "
                "mirrors). Leave it out.",
                scene.faces[face], scene.name);
        }
    }
    scene.faces = std::move(labels);
    scene.canonical += fmt::format("|mirrors={}", fmt::join(mirrors(scene), ","));
    return scene;
}

Surface reflected(const Surface& surface, const Surface& mirror) {
    const Eigen::Vector3d& n = mirror.normal;
    const auto turned = [&](const Eigen::Vector3d& v) { return Eigen::Vector3d(v - 2 * n.dot(v) * n); };
    const auto& [corner, edge_u, edge_v] = parallelogram(surface);
    const Eigen::Vector3d& fixed = parallelogram(mirror).corner;
    const Parallelogram image{fixed + turned(corner - fixed), turned(edge_u), turned(edge_v)};
    return {image, turned(surface.normal), surface.face, surface.grid};
}

std::optional<std::vector<Surface>> images(const Scene& scene, const Surface& surface) {
    std::vector<Surface> all{surface};
    const std::vector<std::uint32_t> found = mirrors(scene);
    if (!found.empty() && !scene.empty_box) return std::nullopt;
    for (auto mirror = found.begin(); mirror != found.end(); ++mirror) {
        const Surface& glass = scene.surfaces[*mirror];
        for (auto other = found.begin(); other != mirror; ++other) {
            if (std::abs(scene.surfaces[*other].normal.dot(glass.normal)) > 0.5) return std::nullopt;
        }
        const std::size_t count = all.size();
        for (std::size_t i = 0; i < count; ++i) all.push_back(reflected(all[i], glass));
    }
    return all;
}

}  // namespace ff
