#include "core/facing.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace ff {
namespace {

/// Room for rounding, relative to the surfaces.
constexpr double tolerance = 1e-12;

/// The least and the greatest height of a surface's corners above the plane of another.
std::pair<double, double> heights(const Surface& above, const Surface& surface) {
    const auto& [corner, edge_u, edge_v] = surface.shape;
    const double base = above.normal.dot(corner - above.shape.corner);
    const double u = above.normal.dot(edge_u);
    const double v = above.normal.dot(edge_v);
    return std::minmax({base, base + u, base + v, base + u + v});
}

double size(const Surface& surface) {
    return surface.shape.edge_u.norm() + surface.shape.edge_v.norm();
}

}  // namespace

bool face_each_other(const Surface& a, const Surface& b) {
    return heights(a, b).second > 0 && heights(b, a).second > 0;
}

bool is_convex(const Scene& scene) {
    for (const Surface& plane : scene.surfaces) {
        for (const Surface& surface : scene.surfaces) {
            if (heights(plane, surface).first < -tolerance * (size(plane) + size(surface))) return false;
        }
    }
    return true;
}

}  // namespace ff
