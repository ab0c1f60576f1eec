#include "core/geometry/placement.hpp"

#include "core/geometry/surface_map.hpp"
#include "core/support/overloaded.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ff {
namespace {

using Eigen::Vector3d;

/// Logarithms of sizes whose squares are ordinary numbers in single precision.
constexpr int most_exponent = 20;

}  // namespace

Placement placement_of(const Scene& scene) {
    Placement placement;
    if (scene.surfaces.empty()) return placement;
    const Eigen::AlignedBox3d box = box_around(scene);
    const double longest = box.sizes().maxCoeff();
    if (!(longest > 0)) return placement;
    const int exponent = std::ilogb(longest);
    const double step = std::ldexp(1.0, exponent);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        if (std::max(std::abs(box.min()[axis]), std::abs(box.max()[axis])) <= far_off * longest) continue;
        placement.origin[axis] = std::round(box.center()[axis] / step) * step;
    }
    if (std::abs(exponent) > most_exponent) placement.unit = step;
    return placement;
}

double farthest_coordinate(const Scene& scene) {
    if (scene.surfaces.empty()) return 0;
    const Eigen::AlignedBox3d box = box_around(scene);
    return std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
}

double rounding_of_far_coordinates(const Scene& scene, const Placement& placement) {
    double rounding = 0;
    const Eigen::AlignedBox3d all = box_around(scene);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        if (placement.origin[axis] == 0) continue;
        const double farthest = std::max(std::abs(all.min()[axis]), std::abs(all.max()[axis]));
        const double last_place = std::ldexp(std::numeric_limits<double>::epsilon(), std::ilogb(farthest));
        const auto is_fine = [&](double end) { return std::remainder(end, 256 * last_place) != 0; };
        const auto has_fine_end = [&](const Surface& surface) {
            const Eigen::AlignedBox3d box = box_around(surface);
            return is_fine(box.min()[axis]) || is_fine(box.max()[axis]);
        };
        if (std::any_of(scene.surfaces.begin(), scene.surfaces.end(), has_fine_end))
            rounding = std::max(rounding, last_place / 2);
    }
    return rounding;
}

Scene placed(const Scene& scene, const Placement& placement) {
    Scene result = scene;
    if (placement.is_identity()) return result;
    result.coordinate_rounding = std::max(scene.coordinate_rounding, rounding_of_far_coordinates(scene, placement));
    const auto move = [&](Vector3d& place) { place = (place - placement.origin) / placement.unit; };
    const auto scale = [&](auto& length) { length /= placement.unit; };
    for (Surface& surface : result.surfaces) {
        std::visit(Overloaded{
                       [&](Parallelogram& p) {
                           move(p.corner);
                           scale(p.edge_u);
                           scale(p.edge_v);
                       },
                       [&](Triangle& p) {
                           for (Vector3d* corner : {&p.a, &p.b, &p.c}) move(*corner);
                       },
                       [&](Disc& p) {
                           move(p.centre);
                           scale(p.inner_radius);
                           scale(p.outer_radius);
                       },
                       [&](Frustum& p) {
                           move(p.base);
                           scale(p.axis);
                           scale(p.base_radius);
                           scale(p.top_radius);
                       },
                       [&](SphereZone& p) {
                           move(p.centre);
                           scale(p.radius);
                       },
                   },
                   surface.shape);
    }
    if (result.empty_box) *result.empty_box /= placement.unit;
    const auto scale_area = [&](double& area) { area /= placement.unit * placement.unit; };
    for (CoveredPart& part : result.covered) {
        scale_area(part.area);
        scale_area(part.whole);
    }
    for (MaskedPart& part : result.masks) scale_area(part.area);
    result.coordinate_rounding /= placement.unit;
    result.coordinate_step /= placement.unit;
    return result;
}

Scene placed(const Scene& scene) {
    return placed(scene, placement_of(scene));
}

}  // namespace ff
