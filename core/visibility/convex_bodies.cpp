#include "core/visibility/convex_bodies.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ff {
namespace {

using Eigen::Vector3d;

constexpr std::uint32_t no_body = std::numeric_limits<std::uint32_t>::max();

/// A body with more is left to the sides themselves: to look at it would take longer than to look at them.
constexpr std::size_t most_sides = 64;

/// Edges whose sides turn by less than about this angle are not those of a convex body, and a line has to be inside of
/// it for this share of its length.
constexpr double clearly = 1e-6;

}  // namespace

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
        result.body_of_.assign(surfaces.size(), no_body);
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
    std::vector<Plane> planes_;  ///< of each surface

    [[nodiscard]] bool is_behind(const ConvexPolygon& polygon, const Plane& plane) const {
        return std::all_of(polygon.begin(), polygon.end(), [&](const Vector3d& corner) {
            return plane.normal.dot(corner) <= plane.offset + result_.room_;
        });
    }

    /// Whether two surfaces with a common edge may be sides of a convex body.
    [[nodiscard]] bool are_convex(std::size_t a, std::size_t b) const {
        const Plane& here = planes_[a];
        const Plane& there = planes_[b];
        return is_behind(edges_.outline(a), there) && is_behind(edges_.outline(b), here) &&
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
            body.planes.push_back(planes_[side]);
            const ConvexPolygon& outline = edges_.outline(side);
            for (std::size_t k = 0; k < outline.size(); ++k) {
                box.extend(outline[k]);
                const std::uint32_t other = edges_.beyond(side, k);
                if (other == SharedEdges::none || std::find(sides.begin(), sides.end(), other) == sides.end() ||
                    !are_convex(side, other))
                    open.push_back({outline[k], next_corner(outline, k)});
            }
        }
        body.size = box.sizes().maxCoeff();
        if (!open.empty()) {
            const auto missing = missing_side(open);
            if (!missing) return std::nullopt;
            body.planes.push_back(*missing);
            body.misses_one = true;
        }
        for (const std::uint32_t side : sides) {
            const auto is_in_front_of = [&](const Plane& plane) { return !is_behind(edges_.outline(side), plane); };
            if (std::any_of(body.planes.begin(), body.planes.end(), is_in_front_of)) return std::nullopt;
        }
        return body;
    }
};

ConvexBodies::ConvexBodies(const std::vector<Surface>& surfaces, const SharedEdges& edges) {
    Finder(*this, surfaces, edges);
}

std::optional<std::uint32_t> ConvexBodies::of(std::size_t surface) const {
    return body_of_[surface] == no_body ? std::nullopt : std::optional(body_of_[surface]);
}

bool ConvexBodies::is_outside(std::uint32_t body_index, std::span<const Vector3d> polygon) const {
    const Body& body = bodies_[body_index];
    const auto all_behind = [&](const Plane& plane) {
        return std::all_of(polygon.begin(), polygon.end(),
                           [&](const Vector3d& v) { return plane.normal.dot(v) <= plane.offset + room_; });
    };
    // What lies in the plane of a side has that side at its back, not before it; a common edge does not matter.
    const auto all_in_front = [&](const Plane& plane) {
        double lowest = std::numeric_limits<double>::max();
        double highest = std::numeric_limits<double>::lowest();
        for (const Vector3d& v : polygon) {
            lowest = std::min(lowest, plane.normal.dot(v) - plane.offset);
            highest = std::max(highest, plane.normal.dot(v) - plane.offset);
        }
        return lowest >= -room_ && highest > clearly * body.size;
    };
    const std::span<const Plane> sides = body.sides();
    return (!body.misses_one || all_behind(body.planes.back())) &&
           std::any_of(sides.begin(), sides.end(), all_in_front);
}

}  // namespace ff
