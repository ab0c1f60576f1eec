#include "core/visibility/standing.hpp"

#include "core/geometry/scene.hpp"
#include "core/geometry/standing_bodies.hpp"
#include "core/visibility/level_overlaps.hpp"

#include <Eigen/Core>

#include <cmath>
#include <numbers>
#include <variant>

namespace ff {
namespace {

using Eigen::Vector3d;

/// A circle at which a round surface ends, and the direction from there along the surface.
struct RoundEnd {
    Vector3d centre;
    double radius = 0;
    Vector3d inwards;
};

std::vector<RoundEnd> ends_of(const Shape& shape) {
    if (const auto* frustum = std::get_if<Frustum>(&shape); frustum && frustum->facing == Facing::outward) {
        const Vector3d along = frustum->axis.normalized();
        return {{frustum->base, frustum->base_radius, along},
                {frustum->base + frustum->axis, frustum->top_radius, -along}};
    }
    if (const auto* zone = std::get_if<SphereZone>(&shape); zone && zone->facing == Facing::outward) {
        const auto end = [&](double height, const Vector3d& inwards) {
            return RoundEnd{zone->centre + height * zone->radius * zone->axis,
                            zone->radius * std::sqrt(1 - height * height), inwards};
        };
        return {end(zone->low, zone->axis), end(zone->high, -zone->axis)};
    }
    return {};
}

}  // namespace

std::vector<std::uint32_t> grounds_in_doubt(const Scene& scene) {
    std::vector<std::uint32_t> found;
    const StandingBodies standing = standing_bodies(scene, doubtful_gap(scene));
    for (std::uint32_t i = 0; i < standing.left.size(); ++i) {
        if (standing.left[i] && !is_along_axes(scene.surfaces[i])) found.push_back(i);
    }
    return found;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> round_bodies_on_surfaces(const Scene& scene) {
    constexpr double least_share = 1e-3;
    const double gap = level_gap(scene);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
    for (std::uint32_t i = 0; i < scene.surfaces.size(); ++i) {
        for (const RoundEnd& end : ends_of(scene.surfaces[i].shape)) {
            const Surface cap{Disc{end.centre, 0, end.radius}, end.inwards, 0};
            const double area = std::numbers::pi * end.radius * end.radius;
            for (std::uint32_t j = 0; j < scene.surfaces.size() && area > 0; ++j) {
                const Surface& ground = scene.surfaces[j];
                if (!is_flat(ground.shape) || ground.normal.dot(end.inwards) < 1 - 1e-9) continue;
                const Extent height = extent(ground, end.inwards);
                const double base = end.centre.dot(end.inwards);
                if (std::abs(height.low - base) > gap || std::abs(height.high - base) > gap) continue;
                if (common_area(ground, cap) > least_share * area) found.emplace_back(i, j);
            }
        }
    }
    return found;
}

}  // namespace ff
