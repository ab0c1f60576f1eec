#include "core/tracing/fine_detail.hpp"

#include "core/geometry/box_tree.hpp"
#include "core/geometry/line_meets.hpp"
#include "core/geometry/placement.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/visibility/level_overlaps.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;

/// Shares of the largest coordinate.
constexpr double narrow = 0x1p-9;
constexpr double near_flat = 0x1p-18;
constexpr double near_curved = 0x1p-7;
/// Sines of angles that are small.
constexpr double small_angle = 0x1p-4;
constexpr double small_angle_of_curves = 0x1p-3;
/// Surfaces cover each other if their common area exceeds this share of the smaller one's area. Adjacent surfaces seem
/// to cover less than that of each other, through rounding.
constexpr double least_share = 1e-6;
constexpr int lattice = 32;

bool has_narrow_face(const Scene& scene, const std::vector<Eigen::AlignedBox3d>& boxes, double largest) {
    std::vector<double> areas(scene.faces.size(), 0);
    std::vector<Eigen::AlignedBox3d> around(scene.faces.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (scene.surfaces[i].face < 0) continue;
        const auto face = static_cast<std::size_t>(scene.surfaces[i].face);
        areas[face] += area(scene.surfaces[i].shape);
        around[face].extend(boxes[i]);
    }
    for (std::size_t face = 0; face < areas.size(); ++face) {
        if (areas[face] > 0 && areas[face] < narrow * largest * around[face].diagonal().norm()) return true;
    }
    return false;
}

bool flat_ones_are_close(const Surface& a, const Surface& b, double distance) {
    if (a.normal.cross(b.normal).norm() > small_angle) return false;
    const Extent plane = extent(a, a.normal);
    const Extent other = extent(b, a.normal);
    if (other.low > plane.high + distance || other.high < plane.low - distance) return false;
    // Neighbours in one plane do not cover each other.
    return common_area(a, b) > least_share * std::min(area(a.shape), area(b.shape));
}

/// Whether some place of a surface has another right above or beneath it, nearly parallel.
bool comes_close(const Surface& surface, const Surface& other, double distance) {
    const SurfaceMap map(surface);
    for (int i = 0; i < lattice * lattice; ++i) {
        const int row = i / lattice;
        const SurfacePoint place = map.at((i % lattice + 0.5) / lattice, (row + 0.5) / lattice);
        for (const Vector3d& direction : {place.normal, Vector3d(-place.normal)}) {
            const auto meeting = line_meets({place.position, direction}, other);
            if (!meeting || meeting->time > distance) continue;
            const Vector3d normal = normal_at(other, place.position + meeting->time * direction);
            if (normal.cross(direction).norm() <= small_angle_of_curves) return true;
        }
    }
    return false;
}

}  // namespace

bool has_fine_detail(const Scene& scene) {
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const Surface& surface : scene.surfaces) boxes.push_back(box_around(surface));
    const double largest = farthest_coordinate(scene);
    if (has_narrow_face(scene, boxes, largest)) return true;
    const BoxTree tree(boxes);
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        const Surface& a = scene.surfaces[i];
        const bool is_curved = !is_flat(a.shape);
        const Vector3d room = Vector3d::Constant((is_curved ? near_curved : near_flat) * largest);
        bool close = false;
        tree.within({boxes[i].min() - room, boxes[i].max() + room}, [&](std::uint32_t j) {
            if (close || j == i) return;
            const Surface& b = scene.surfaces[j];
            if (is_curved) {
                close = comes_close(a, b, near_curved * largest) || comes_close(b, a, near_curved * largest);
            } else if (is_flat(b.shape) && j > i) {
                close = flat_ones_are_close(a, b, near_flat * largest);
            }
        });
        if (close) return true;
    }
    return false;
}

}  // namespace ff
