#include "core/geometry/facets.hpp"

#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/support/contract.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;

/// Values of s at which a shape is cut, and how far it bulges over straight lines between them.
struct Rings {
    std::vector<double> s{0, 1};
    double bulge = 0;
    double radius = 0;  ///< the largest
};

Rings rings_of(const Shape& shape, std::size_t facets) {
    Rings rings;
    if (const auto* disc = std::get_if<Disc>(&shape)) {
        rings.radius = disc->outer_radius;
    } else if (const auto* wall = std::get_if<Frustum>(&shape)) {
        rings.radius = std::max(wall->base_radius, wall->top_radius);
    } else {
        const auto& zone = std::get<SphereZone>(shape);
        const double first = std::acos(zone.low);  // angles from the axis
        const double last = std::acos(zone.high);
        const double step = 2 * std::numbers::pi / static_cast<double>(facets);
        const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil((first - last) / step - 1e-9)));
        rings.s.clear();
        for (std::size_t k = 0; k <= count; ++k) {
            const double share = static_cast<double>(k) / static_cast<double>(count);
            const double height = std::cos(first + share * (last - first));
            rings.s.push_back(std::clamp((height - zone.low) / (zone.high - zone.low), 0.0, 1.0));
        }
        rings.bulge = zone.radius * (1 - std::cos((first - last) / static_cast<double>(2 * count)));
        rings.radius = zone.radius;
    }
    return rings;
}

/// Adds a plane polygon of three or four corners that radiates to the side of a normal.
void add(std::vector<Surface>& surfaces, ConvexPolygon corners, const Vector3d& outwards, int face) {
    const auto is_same = [](const Vector3d& a, const Vector3d& b) { return (a - b).norm() <= 1e-14 * (a + b).norm(); };
    corners.erase(std::unique(corners.begin(), corners.end(), is_same), corners.end());
    if (corners.size() > 1 && is_same(corners.front(), corners.back())) corners.pop_back();
    if (corners.size() < 3) return;
    turn_around(corners, outwards);
    const Vector3d normal = twice_area(corners).normalized();
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
        surfaces.push_back({Triangle{corners[0], corners[k], corners[k + 1]}, normal, face});
}

}  // namespace

FacetedScene with_facets(const Scene& scene, std::size_t facets) {
    FF_EXPECT(facets >= 3);
    FacetedScene result;
    result.scene = scene;
    result.scene.surfaces.clear();
    for (const Surface& surface : scene.surfaces) {
        if (is_polygon(surface.shape)) {
            result.scene.surfaces.push_back(surface);
            continue;
        }
        ++result.curved;
        const SurfaceMap map(surface);
        const Rings rings = rings_of(surface.shape, facets);
        const auto at = [&](double s, std::size_t k) {
            return map.at(s, static_cast<double>(k % facets) / static_cast<double>(facets)).position;
        };
        for (std::size_t ring = 0; ring + 1 < rings.s.size(); ++ring) {
            const double low = rings.s[ring];
            const double high = rings.s[ring + 1];
            for (std::size_t k = 0; k < facets; ++k) {
                const double middle = (static_cast<double>(k) + 0.5) / static_cast<double>(facets);
                add(result.scene.surfaces, {at(low, k), at(low, k + 1), at(high, k + 1), at(high, k)},
                    map.at((low + high) / 2, middle).normal, surface.face);
            }
        }
        const double around = rings.radius * (1 - std::cos(std::numbers::pi / static_cast<double>(facets)));
        result.deviation = std::max(result.deviation, around + rings.bulge);
    }
    return result;
}

}  // namespace ff
