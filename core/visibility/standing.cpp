#include "core/visibility/standing.hpp"

#include "core/geometry/round_ends.hpp"
#include "core/geometry/scene.hpp"
#include "core/geometry/standing_bodies.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/visibility/level_overlaps.hpp"

#include <cmath>
#include <numbers>

namespace ff {
std::vector<std::uint32_t> grounds_in_doubt(const Scene& scene) {
    std::vector<std::uint32_t> found;
    const StandingBodies standing = standing_bodies(scene, doubtful_gap(scene));
    for (std::uint32_t i = 0; i < standing.left.size(); ++i) {
        if (standing.left[i] && !is_along_axes(scene.surfaces[i])) found.push_back(i);
    }
    return found;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> round_bodies_on_surfaces(const Scene& scene) {
    constexpr double least_covered = 1e-3;
    const double gap = level_gap(scene);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
    for (std::uint32_t i = 0; i < scene.surfaces.size(); ++i) {
        const Shape& shape = scene.surfaces[i].shape;
        if (is_flat(shape) || facing(shape) == Facing::inward) continue;
        for (const RoundEnd& end : round_ends(shape)) {
            const Surface cap{Disc{end.centre, 0, end.radius}, end.inwards, 0};
            const double area = std::numbers::pi * end.radius * end.radius;
            for (std::uint32_t j = 0; j < scene.surfaces.size(); ++j) {
                const Surface& ground = scene.surfaces[j];
                if (!is_flat(ground.shape) || ground.normal.dot(end.inwards) < 1 - 1e-9) continue;
                const Extent height = extent(ground, end.inwards);
                const double base = end.centre.dot(end.inwards);
                if (std::abs(height.low - base) > gap || std::abs(height.high - base) > gap) continue;
                if (common_area(ground, cap) > least_covered * area) found.emplace_back(i, j);
            }
        }
    }
    return found;
}

}  // namespace ff
