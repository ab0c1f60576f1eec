#include "core/visibility/level_overlaps.hpp"

#include "core/geometry/box_tree.hpp"
#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/line_meets.hpp"
#include "core/geometry/placement.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/visibility/facing.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ff {
namespace {

using Eigen::Vector3d;

/// Overlaps are ignored up to this share of the smaller surface's area: adjacent surfaces seem to overlap that much
/// through rounding.
constexpr double least_share = 1e-6;
/// How many times as far as a coordinate the plane of a surface may be off beside its corners.
constexpr double planes_off = 16;
/// Surfaces are taken to lie in one plane if they are off it by at most this share of the smaller surface's size, which
/// is the root of its area.
constexpr double near = 1e-6;
/// How many steps of coordinates what lies in a slanting plane may be apart once it is rounded to them.
constexpr double steps_off = 2;
/// A surface that lies on another by more than this share of its area was not meant to abut it.
constexpr double most_by_rounding = 0.05;
/// Places of a disc along each of its coordinates.
constexpr int lattice = 32;

double area_along(const ConvexPolygon& polygon, const Vector3d& normal) {
    double sum = 0;
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
        sum += (polygon[k] - polygon[0]).cross(polygon[k + 1] - polygon[0]).dot(normal);
    return std::abs(sum) / 2;
}

double common_area_of_polygons(const Surface& a, const ConvexPolygon& of_a, const ConvexPolygon& of_b) {
    Vector3d upwards = (of_a[1] - of_a[0]).cross(of_a[2] - of_a[1]);
    ConvexPolygon common = of_b;
    for (std::size_t k = 0; k < of_a.size(); ++k) {
        const Vector3d inwards = upwards.cross(next_corner(of_a, k) - of_a[k]);
        common = part_above(common, [&](const Vector3d& place) { return inwards.dot(place - of_a[k]); });
    }
    return area_along(common, a.normal);
}

/// The share of places of a surface that another lies above or beneath.
double covered_share(const Surface& surface, const Surface& by) {
    const SurfaceMap map(surface);
    // So far away that rounding of the place does not show beside the distance.
    const double distance = std::sqrt(area(surface.shape));
    int covered = 0;
    for (int i = 0; i < lattice * lattice; ++i) {
        const int row = i / lattice;
        const Vector3d place = map.at((i % lattice + 0.5) / lattice, (row + 0.5) / lattice).position;
        covered += line_meets({place + distance * surface.normal, -surface.normal}, by).has_value();
    }
    return covered / double{lattice * lattice};
}

/// Whether a flat surface lies within `gap` of the plane of another, or the other way round: the plane of a small one,
/// rounded as its corners are, may be far off a large one.
bool lie_in_one_plane(const Surface& a, const Surface& b, double gap) {
    const auto heights = [](const Surface& flat, const Surface& other) {
        const Extent own = extent(flat, flat.normal);
        const Extent along = extent(other, flat.normal);
        return std::max(std::abs(along.high - own.low), std::abs(along.low - own.high));
    };
    return std::min(heights(a, b), heights(b, a)) <= gap;
}

/// Whether each edge of a polygon is along an axis: rounding moves all edges on such a line to the same place.
bool has_edges_along_axes(const Surface& surface) {
    const ConvexPolygon polygon = corners(surface.shape);
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Eigen::Array3d edge = (next_corner(polygon, k) - polygon[k]).array().abs();
        if (edge.sum() > (1 + 1e-14) * edge.maxCoeff()) return false;
    }
    return true;
}

}  // namespace

double common_area(const Surface& a, const Surface& b) {
    const ConvexPolygon of_a = corners(a.shape);
    const ConvexPolygon of_b = corners(b.shape);
    if (!of_a.empty() && !of_b.empty()) return common_area_of_polygons(a, of_a, of_b);
    return std::max(covered_share(a, b) * area(a.shape), covered_share(b, a) * area(b.shape));
}

double level_gap(const Scene& scene) {
    constexpr double rounding = std::numeric_limits<double>::epsilon();
    return std::max({rounding_room * box_around(scene).diagonal().norm(), 8 * rounding * farthest_coordinate(scene),
                     planes_off * scene.coordinate_rounding});
}

double doubtful_gap(const Scene& scene) {
    return steps_off * scene.coordinate_step;
}

bool is_along_axes(const Surface& surface) {
    return surface.normal.cwiseAbs().maxCoeff() > 1 - 1e-14;
}

std::vector<LevelOverlap> level_overlaps(const Scene& scene) {
    const std::vector<Eigen::AlignedBox3d> boxes = boxes_around(scene.surfaces);
    const double gap = level_gap(scene);
    const BoxTree tree(boxes);
    std::vector<LevelOverlap> overlaps;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        const Surface& a = scene.surfaces[i];
        if (!is_flat(a.shape)) continue;
        const double doubt = is_along_axes(a) ? 0 : doubtful_gap(scene);
        tree.within(boxes[i], std::max({gap, doubt, near * std::sqrt(area(a.shape))}), [&](std::uint32_t j) {
            const Surface& b = scene.surfaces[j];
            if (j <= i || !is_flat(b.shape)) return;
            const double smaller = std::min(area(a.shape), area(b.shape));
            if (!lie_in_one_plane(a, b, std::max({gap, doubt, near * std::sqrt(smaller)}))) return;
            const double common = common_area(a, b);
            // Along its rim, which for what is long and thin is longer than the root of its area.
            const double rim = boxes[i].intersection(boxes[j]).diagonal().norm() + std::sqrt(smaller);
            const bool level = lie_in_one_plane(a, b, gap);
            const double rounding = level ? 4 * gap / planes_off : doubt;
            if (common <= std::max(least_share * smaller, rounding * rim)) return;
            const bool by_rounding = level &&
                                     common <= std::min(doubtful_gap(scene) * rim, most_by_rounding * smaller) &&
                                     !(has_edges_along_axes(a) && has_edges_along_axes(b));
            overlaps.push_back({i, j, a.normal.dot(b.normal) > 0, common, level,
                                !level && lie_in_one_plane(a, b, doubt), by_rounding});
        });
    }
    std::sort(overlaps.begin(), overlaps.end(), [](const LevelOverlap& a, const LevelOverlap& b) {
        return std::pair(a.first, a.second) < std::pair(b.first, b.second);
    });
    return overlaps;
}

}  // namespace ff
