#include "studies/form_factors/point_factors.hpp"

#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/support/error.hpp"
#include "core/visibility/level_overlaps.hpp"
#include "core/visibility/visible_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ff::studies::form_factors {

using Eigen::Vector3d;

PointFactors::PointFactors(const Scene& scene) : placement_(placement_of(scene)), scene_(placed(scene, placement_)) {
    for (const Surface& surface : scene_.surfaces) {
        if (!is_polygon(surface.shape))
            throw UserError(
                "--from: scene '{}' has curved surfaces (what a point sees is found past polygons). Make them polygons "
                "by 'ffstudy convert --facets'.",
                scene.name);
        boxes_.push_back(box_around(surface));
    }
    constexpr double roundings = 64;  // possible roundings of a distance from a plane
    gap_ = roundings * std::numeric_limits<double>::epsilon() * farthest_coordinate(scene_);
    level_.resize(scene_.surfaces.size());
    for (const LevelOverlap& overlap : level_overlaps(scene_)) {
        if (!overlap.level) continue;
        level_[overlap.first].push_back(overlap.second);
        level_[overlap.second].push_back(overlap.first);
    }
}

std::vector<PointFactor> PointFactors::from(const Vector3d& given, const Vector3d& direction) const {
    // Rounding error of the angles between edges, for each edge that may take part.
    constexpr double rounding = 1e-13;
    const Vector3d place = (given - placement_.origin) / placement_.unit;
    const Vector3d normal = direction.stableNormalized();
    std::vector<bool> is_on(scene_.surfaces.size());  // a surface that the point lies on hides nothing from it
    for (std::size_t s = 0; s < scene_.surfaces.size(); ++s) {
        const Surface& surface = scene_.surfaces[s];
        is_on[s] = std::abs(surface.normal.dot(place - corners(surface.shape).front())) <= gap_;
    }
    std::vector<PointFactor> factors(scene_.faces.size());
    for (std::size_t t = 0; t < scene_.surfaces.size(); ++t) {
        const Surface& target = scene_.surfaces[t];
        if (target.face < 0) continue;
        const ConvexPolygon outline = corners(target.shape);
        const bool is_before = !is_on[t] && target.normal.dot(place - outline.front()) > 0;
        const bool is_above = std::any_of(outline.begin(), outline.end(),
                                          [&](const Vector3d& corner) { return normal.dot(corner - place) > 0; });
        if (!is_before || !is_above) continue;
        Eigen::AlignedBox3d between = boxes_[t];
        between.extend(place);
        std::vector<Blocker> blockers;
        for (std::size_t b = 0; b < scene_.surfaces.size(); ++b) {
            const bool is_level = std::find(level_[t].begin(), level_[t].end(), b) != level_[t].end();
            if (b != t && !is_level && !is_on[b] && boxes_[b].intersects(between))
                blockers.emplace_back(&scene_.surfaces[b]);
        }
        const auto found = VisiblePolygon(target, blockers).from(place, normal);
        const double error = rounding * static_cast<double>(1 + blockers.size());
        PointFactor& factor = factors[static_cast<std::size_t>(target.face)];
        factor.value += std::clamp(found.visible, 0.0, 1.0);
        factor.low += std::max(0.0, found.visible - error);
        factor.high += std::min(found.visible, found.whole) + error;
    }
    for (PointFactor& factor : factors) {
        factor.low = std::min(factor.low, factor.value);
        factor.high = std::min(1.0, std::max(factor.high, factor.value));
        factor.value = std::min(1.0, factor.value);
    }
    return factors;
}

}  // namespace ff::studies::form_factors
