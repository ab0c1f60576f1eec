#include "core/visibility/closed_meshes.hpp"

#include "core/geometry/box_tree.hpp"

#include <algorithm>
#include <cmath>

namespace ff {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

/// A mesh has to fill this share of the box around it, so that rounding does not decide which side is its inside.
constexpr double least_volume = 1e-9;

/// A surface beside a mesh has to reach so far beyond it, as a share of its size.
constexpr double least_reach = 1e-6;

AlignedBox3d box_around(std::span<const Vector3d> polygon) {
    AlignedBox3d box;
    for (const Vector3d& corner : polygon) box.extend(corner);
    return box;
}

double volume_of(const std::vector<std::uint32_t>& sides, const SharedEdges& edges) {
    const Vector3d origin = edges.outline(sides.front()).front();
    double volume = 0;
    for (const std::uint32_t side : sides) {
        const ConvexPolygon& outline = edges.outline(side);
        volume += twice_area(outline).dot(outline.front() - origin) / 6;
    }
    return volume;
}

/// Whether an edge of a polygon that has no corner in common with another meets that.
bool cuts(const ConvexPolygon& polygon, const ConvexPolygon& other, double room) {
    const Vector3d normal = twice_area(other).normalized();
    const auto is_corner = [&](const Vector3d& place) {
        return std::any_of(other.begin(), other.end(), [&](const Vector3d& v) { return (v - place).norm() <= room; });
    };
    const auto is_on = [&](const Vector3d& place) {
        for (std::size_t k = 0; k < other.size(); ++k) {
            const Vector3d along = next_corner(other, k) - other[k];
            if (normal.cross(along).dot(place - other[k]) < -room * along.norm()) return false;
        }
        return true;
    };
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vector3d& from = polygon[k];
        const Vector3d& to = next_corner(polygon, k);
        if (is_corner(from) || is_corner(to)) continue;
        const double before = normal.dot(from - other.front());
        const double after = normal.dot(to - other.front());
        if (std::min(before, after) > room || std::max(before, after) < -room) continue;
        const double time = before == after ? 0.5 : std::clamp(before / (before - after), 0.0, 1.0);
        if (is_on(from + time * (to - from))) return true;
    }
    return false;
}

bool cuts_through_itself(const std::vector<std::uint32_t>& sides, const SharedEdges& edges, double room) {
    std::vector<AlignedBox3d> boxes;
    for (const std::uint32_t side : sides) boxes.push_back(box_around(edges.outline(side)));
    const BoxTree tree(boxes);
    bool found = false;
    for (std::size_t i = 0; i < sides.size() && !found; ++i) {
        tree.within({boxes[i].min().array() - room, boxes[i].max().array() + room}, [&](std::uint32_t j) {
            found = found || (i != j && cuts(edges.outline(sides[i]), edges.outline(sides[j]), room));
        });
    }
    return found;
}

bool is_closed(const std::vector<std::uint32_t>& sides, const SharedEdges& edges) {
    return std::all_of(sides.begin(), sides.end(), [&](std::uint32_t side) {
        const std::size_t count = edges.outline(side).size();
        for (std::size_t k = 0; k < count; ++k) {
            if (edges.beyond(side, k) == SharedEdges::none) return false;
        }
        return count > 0;
    });
}

}  // namespace

ClosedMeshes::ClosedMeshes(const SharedEdges& edges)
    : mesh_of_(edges.size(), SharedEdges::none), room_(edges.corner_room()) {
    for (const auto& sides : edges.groups([](std::size_t, std::size_t) { return true; })) {
        if (!is_closed(sides, edges)) continue;
        Mesh mesh;
        for (const std::uint32_t side : sides) mesh.box.extend(box_around(edges.outline(side)));
        const double volume = volume_of(sides, edges);
        if (std::abs(volume) < least_volume * mesh.box.volume() || cuts_through_itself(sides, edges, room_)) continue;
        mesh.is_body = volume > 0;
        for (const std::uint32_t side : sides) mesh_of_[side] = static_cast<std::uint32_t>(meshes_.size());
        meshes_.push_back(mesh);
    }
}

bool ClosedMeshes::is_on_free_side(std::uint32_t mesh, std::size_t surface, std::span<const Vector3d> polygon) const {
    if (mesh_of_[surface] == mesh) return true;
    if (!meshes_[mesh].is_body) return false;
    // What lies in the plane of a side may be covered by it, and then sees the others from behind.
    const AlignedBox3d& body = meshes_[mesh].box;
    const AlignedBox3d box = box_around(polygon);
    const double beyond = least_reach * body.sizes().maxCoeff();
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        if (box.min()[axis] >= body.max()[axis] - room_ && box.max()[axis] > body.max()[axis] + beyond) return true;
        if (box.max()[axis] <= body.min()[axis] + room_ && box.min()[axis] < body.min()[axis] - beyond) return true;
    }
    return false;
}

}  // namespace ff
