#include "core/visibility/bodies.hpp"

#include "core/geometry/box_tree.hpp"
#include "core/geometry/surface_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace ff {
namespace {

/// Joining surfaces rounds their corners (core/geometry/joined_surfaces.hpp), by this share of the largest coordinate.
constexpr double corner_rounding = 1e-11;

/// Edges meet where corners are in one cell of a grid of this width. What is missed stays apart.
constexpr double same_corner = 1e-9;

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

/// A body with more sides is not used as a body: examining it would take longer than examining its sides.
constexpr std::size_t most_sides = 64;

/// Edges whose sides turn by less than about this angle are not those of a convex body, and a line has to be inside of
/// it for this share of its length.
constexpr double clearly = 1e-6;

/// A mesh has to fill this share of the box around it, so that rounding does not decide which side is its inside.
constexpr double least_volume = 1e-9;

/// A surface beside a mesh has to reach so far beyond it, as a share of its size.
constexpr double least_reach = 1e-6;

double volume_of(const std::vector<std::uint32_t>& sides, const SharedEdges& edges) {
    const Vector3d origin = edges.outline(sides.front()).front();
    double volume = 0;
    for (const std::uint32_t side : sides) {
        const ConvexPolygon& outline = edges.outline(side);
        volume += twice_area(outline).dot(outline.front() - origin) / 6;
    }
    return volume;
}

/// Whether an edge of a polygon meets another polygon with which it has no corner in common.
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
        tree.within(boxes[i], room, [&](std::uint32_t j) {
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

SharedEdges::SharedEdges(const std::vector<Surface>& surfaces) {
    double farthest = 0;
    for (const Surface& surface : surfaces) {
        outlines_.push_back(ff::outline(surface));
        for (const Eigen::Vector3d& corner : outlines_.back())
            farthest = std::max(farthest, corner.lpNorm<Eigen::Infinity>());
    }
    corner_room_ = corner_rounding * farthest;
    const double step = same_corner * farthest;
    using Corner = std::array<std::int64_t, 3>;
    const auto name_of = [&](const Eigen::Vector3d& place) {
        // Coordinates are often multiples of something, which lie in the middle of a cell so.
        const Eigen::Vector3d steps = (place / step).array() + 0.5;
        return Corner{std::llround(std::floor(steps.x())), std::llround(std::floor(steps.y())),
                      std::llround(std::floor(steps.z()))};
    };
    struct Edge {
        std::uint32_t surface;
        std::size_t place;
        bool alone = true;  ///< no other surface has it in the same direction
    };
    std::map<std::pair<Corner, Corner>, Edge> edges;
    for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
        const ConvexPolygon& outline = outlines_[s];
        first_.push_back(beyond_.size());
        for (std::size_t k = 0; k < outline.size(); ++k) {
            const std::pair ends(name_of(outline[k]), name_of(next_corner(outline, k)));
            const auto [known, is_new] = edges.try_emplace(ends, Edge{s, beyond_.size()});
            if (!is_new) known->second.alone = false;
            beyond_.push_back(none);
        }
    }
    const auto are_same = [&](const Edge& edge, const Edge& turned) {
        const auto ends = [&](const Edge& of) {
            const ConvexPolygon& outline = outlines_[of.surface];
            const std::size_t k = of.place - first_[of.surface];
            return std::pair(outline[k], next_corner(outline, k));
        };
        const auto [from, to] = ends(edge);
        const auto [last, first] = ends(turned);
        return (from - first).norm() <= 4 * corner_room_ && (to - last).norm() <= 4 * corner_room_;
    };
    for (const auto& [ends, edge] : edges) {
        const auto found = edges.find({ends.second, ends.first});
        if (found != edges.end() && found->second.alone && edge.alone && are_same(edge, found->second))
            beyond_[edge.place] = found->second.surface;
    }
}

/// Joins surfaces along common edges, and keeps what is convex.
class ConvexBodies::Finder {
  public:
    Finder(ConvexBodies& result, const std::vector<Surface>& surfaces, const SharedEdges& edges)
        : result_(result), edges_(edges) {
        for (std::size_t s = 0; s < surfaces.size(); ++s) {
            const ConvexPolygon& outline = edges.outline(s);
            const Vector3d normal = surfaces[s].normal.normalized();
            planes_.push_back({normal, outline.empty() ? 0 : normal.dot(outline.front())});
        }
        result.room_ = edges.corner_room();
        result.body_of_.assign(surfaces.size(), SharedEdges::none);
        for (const auto& sides : edges.groups([&](std::size_t a, std::size_t b) { return are_convex(a, b); })) {
            std::optional<Body> body = body_of(sides);
            if (!body) continue;
            for (const std::size_t side : sides)
                result.body_of_[side] = static_cast<std::uint32_t>(result.bodies_.size());
            result.bodies_.push_back(std::move(*body));
        }
    }

  private:
    struct Edge {
        Vector3d from, to;
    };

    ConvexBodies& result_;
    const SharedEdges& edges_;
    std::vector<Plane> planes_;  ///< one for each surface

    /// Whether two surfaces with a common edge may be sides of a convex body.
    [[nodiscard]] bool are_convex(std::size_t a, std::size_t b) const {
        const Plane& here = planes_[a];
        const Plane& there = planes_[b];
        return result_.is_behind(edges_.outline(a), there) && result_.is_behind(edges_.outline(b), here) &&
               here.normal.cross(there.normal).norm() > clearly;
    }

    /// Along edges that only one side has. Empty unless they go round a single convex hole.
    [[nodiscard]] std::optional<Plane> missing_side(const std::vector<Edge>& open) const {
        Vector3d twice_area = Vector3d::Zero();
        Vector3d gap = Vector3d::Zero();
        for (const Edge& edge : open) {
            const Vector3d from = edge.from - open.front().from;
            const Vector3d to = edge.to - open.front().from;
            twice_area += to.cross(from);
            gap += to - from;
        }
        if (gap.norm() > static_cast<double>(open.size()) * 100 * result_.room_ || !(twice_area.norm() > 0))
            return std::nullopt;
        const Vector3d normal = twice_area.normalized();
        Plane plane{normal, normal.dot(open.front().from)};
        for (const Edge& edge : open) {
            if (normal.dot(edge.from) < plane.offset - result_.room_) return std::nullopt;
        }
        return plane;
    }

    std::optional<Body> body_of(const std::vector<std::uint32_t>& sides) {
        if (sides.size() < 3 || sides.size() > most_sides) return std::nullopt;
        Body body;
        std::vector<Edge> open;
        Eigen::AlignedBox3d box;
        for (const std::uint32_t side : sides) {
            body.sides.push_back(planes_[side]);
            const ConvexPolygon& outline = edges_.outline(side);
            box.extend(box_around(outline));
            for (std::size_t k = 0; k < outline.size(); ++k) {
                const std::uint32_t other = edges_.beyond(side, k);
                if (other == SharedEdges::none || std::find(sides.begin(), sides.end(), other) == sides.end() ||
                    !are_convex(side, other))
                    open.push_back({outline[k], next_corner(outline, k)});
            }
        }
        body.size = box.sizes().maxCoeff();
        if (!open.empty()) {
            body.missing = missing_side(open);
            if (!body.missing) return std::nullopt;
        }
        for (const std::uint32_t side : sides) {
            const auto is_behind = [&](const Plane& plane) { return result_.is_behind(edges_.outline(side), plane); };
            if (!std::all_of(body.sides.begin(), body.sides.end(), is_behind) ||
                (body.missing && !is_behind(*body.missing)))
                return std::nullopt;
        }
        return body;
    }
};

bool ConvexBodies::is_behind(std::span<const Vector3d> polygon, const Plane& plane) const {
    return std::all_of(polygon.begin(), polygon.end(),
                       [&](const Vector3d& corner) { return plane.normal.dot(corner) <= plane.offset + room_; });
}

ConvexBodies::ConvexBodies(const std::vector<Surface>& surfaces, const SharedEdges& edges) {
    Finder(*this, surfaces, edges);
}

bool ConvexBodies::is_outside(std::uint32_t body_index, std::span<const Vector3d> polygon) const {
    const Body& body = bodies_[body_index];
    // A polygon in the plane of a side has that side behind it, not before it; a common edge does not matter.
    const auto all_in_front = [&](const Plane& plane) {
        const Extent heights = extent(polygon, plane.normal);
        return heights.low - plane.offset >= -room_ && heights.high - plane.offset > clearly * body.size;
    };
    return (!body.missing || is_behind(polygon, *body.missing)) &&
           std::any_of(body.sides.begin(), body.sides.end(), all_in_front);
}

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
    // A polygon in the plane of a side may be covered by it, and then sees the others from behind.
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
