#include "core/patches/unfold.hpp"

#include "core/visibility/mirrors.hpp"

#include <algorithm>
#include <limits>

namespace ff {
namespace {

/// The plane of the first surface, with two of its edges as axes.
struct Plane {
    Eigen::Vector3d corner;
    Eigen::Vector3d right;  ///< unit vectors
    Eigen::Vector3d up;
    Eigen::Vector3d normal;
    double width = 0;
    double height = 0;
};

enum class BoxSide { middle, left, right, bottom, top, opposite };

BoxSide side_of(const Plane& plane, const Surface& surface) {
    const double across = surface.normal.dot(plane.right);
    const double along = surface.normal.dot(plane.up);
    if (surface.normal.dot(plane.normal) > 0.5) return BoxSide::middle;
    if (across > 0.5) return BoxSide::left;  // normals point into the box
    if (across < -0.5) return BoxSide::right;
    if (along > 0.5) return BoxSide::bottom;
    return along < -0.5 ? BoxSide::top : BoxSide::opposite;
}

/// Where a point of the surface at `side` lies after unfolding.
Eigen::Vector2d unfold(const Plane& plane, BoxSide side, double depth, const Eigen::Vector3d& point) {
    const Eigen::Vector3d offset = point - plane.corner;
    const double x = offset.dot(plane.right);
    const double y = offset.dot(plane.up);
    const double z = offset.dot(plane.normal);
    switch (side) {
        case BoxSide::left:
            return {-z, y};
        case BoxSide::right:
            return {plane.width + z, y};
        case BoxSide::bottom:
            return {x, -z};
        case BoxSide::top:
            return {x, plane.height + z};
        case BoxSide::opposite:
            return {2 * plane.width + depth - x, y};
        case BoxSide::middle:
            break;
    }
    return {x, y};
}

FlatRectangle flatten(const Plane& plane, BoxSide side, double depth, const Parallelogram& shape) {
    const Eigen::Vector2d a = unfold(plane, side, depth, shape.corner);
    const Eigen::Vector2d b = unfold(plane, side, depth, shape.corner + shape.edge_u + shape.edge_v);
    return {std::min(a.x(), b.x()), std::min(a.y(), b.y()), std::max(a.x(), b.x()), std::max(a.y(), b.y())};
}

}  // namespace

std::optional<UnfoldedBox> unfold_box(const Scene& scene, Subdivision subdivision) {
    if (!scene.empty_box || !mirrors(scene).empty() || scene.surfaces.size() != 6) return std::nullopt;
    if (has_grids(scene)) return std::nullopt;
    const auto& [corner, edge_u, edge_v] = parallelogram(scene.surfaces.front());
    const Plane plane{corner,        edge_u.normalized(), edge_v.normalized(), scene.surfaces.front().normal,
                      edge_u.norm(), edge_v.norm()};
    // The box is as deep as the surface that reaches farthest from the first.
    double depth = 0;
    for (const Surface& surface : scene.surfaces)
        depth = std::max(depth, (parallelogram(surface).corner - plane.corner).dot(plane.normal));
    UnfoldedBox box;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    box.extent = {infinity, infinity, -infinity, -infinity};
    for (const Surface& surface : scene.surfaces) {
        const BoxSide side = side_of(plane, surface);
        const FlatRectangle whole = flatten(plane, side, depth, parallelogram(surface));
        box.surfaces.push_back(whole);
        box.extent = {std::min(box.extent.left, whole.left), std::min(box.extent.bottom, whole.bottom),
                      std::max(box.extent.right, whole.right), std::max(box.extent.top, whole.top)};
        for (std::uint32_t p = 0; p < subdivision.per_part(); ++p)
            box.patches.push_back(
                flatten(plane, side, depth, patch(parallelogram(surface), subdivision.of(surface), p)));
    }
    return box;
}

}  // namespace ff
