#include "core/visibility/convex_bodies.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace ff {
namespace {

using Eigen::Vector3d;

constexpr std::uint32_t no_body = std::numeric_limits<std::uint32_t>::max();

/// Joining surfaces rounds their corners (core/geometry/joined_surfaces.hpp), by this share of the largest coordinate.
constexpr double corner_rounding = 1e-11;

/// Sides meet where corners are this near to each other. What is missed stays single surfaces.
constexpr double same_corner = 1e-9;

/// Edges whose sides turn by less than about this angle are not those of a convex body, and a line has to be inside of
/// it for this share of its length.
constexpr double clearly = 1e-6;

}  // namespace

/// Joins surfaces along common edges, and keeps what is convex.
class ConvexBodies::Finder {
  public:
    Finder(ConvexBodies& result, const std::vector<Surface>& surfaces) : result_(result), parent_(surfaces.size()) {
        double farthest = 0;
        for (const Surface& surface : surfaces) {
            outlines_.push_back(outline(surface));
            for (const Vector3d& corner : outlines_.back())
                farthest = std::max(farthest, corner.lpNorm<Eigen::Infinity>());
            const Vector3d normal = surface.normal.normalized();
            result.planes_.push_back({normal, outlines_.back().empty() ? 0 : normal.dot(outlines_.back().front())});
        }
        result.room_ = corner_rounding * farthest;
        step_ = same_corner * farthest;
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
        find_edges();
        for (const auto& [ends, edge] : edges_) {
            if (const Edge* other = across(ends, edge)) parent_[root(edge.surface)] = root(other->surface);
        }
        std::map<std::size_t, std::vector<std::size_t>> groups;
        for (std::size_t s = 0; s < surfaces.size(); ++s) groups[root(s)].push_back(s);
        result.body_of_.assign(surfaces.size(), no_body);
        for (const auto& [first, sides] : groups) {
            std::optional<Body> body = body_of(sides);
            if (!body) continue;
            for (const std::size_t side : sides)
                result.body_of_[side] = static_cast<std::uint32_t>(result.bodies_.size());
            result.bodies_.push_back(std::move(*body));
        }
    }

  private:
    using Corner = std::array<std::int64_t, 3>;

    struct Edge {
        std::size_t surface = 0;
        Vector3d from, to;
        bool alone = true;  ///< no other surface has it in the same direction
    };

    ConvexBodies& result_;
    std::vector<ConvexPolygon> outlines_;
    std::map<std::pair<Corner, Corner>, Edge> edges_;
    std::vector<std::size_t> parent_;
    double step_ = 0;

    [[nodiscard]] Corner name_of(const Vector3d& place) const {
        // Coordinates are often multiples of something, which lie in the middle of a step so.
        const Vector3d steps = (place / step_).array() + 0.5;
        return {std::llround(std::floor(steps.x())), std::llround(std::floor(steps.y())),
                std::llround(std::floor(steps.z()))};
    }

    void find_edges() {
        for (std::size_t s = 0; s < outlines_.size(); ++s) {
            const ConvexPolygon& outline = outlines_[s];
            for (std::size_t k = 0; k < outline.size(); ++k) {
                const Vector3d& from = outline[k];
                const Vector3d& to = next_corner(outline, k);
                const auto [known, is_new] = edges_.try_emplace({name_of(from), name_of(to)}, Edge{s, from, to});
                if (!is_new) known->second.alone = false;
            }
        }
    }

    [[nodiscard]] std::size_t root(std::size_t surface) {
        while (parent_[surface] != surface) surface = parent_[surface] = parent_[parent_[surface]];
        return surface;
    }

    [[nodiscard]] bool is_behind(const ConvexPolygon& polygon, const Plane& plane) const {
        return std::all_of(polygon.begin(), polygon.end(), [&](const Vector3d& corner) {
            return plane.normal.dot(corner) <= plane.offset + result_.room_;
        });
    }

    /// The edge of the surface that meets this one there, where the two are part of a convex body.
    [[nodiscard]] const Edge* across(const std::pair<Corner, Corner>& ends, const Edge& edge) const {
        const auto found = edges_.find({ends.second, ends.first});
        if (found == edges_.end() || !found->second.alone || !edge.alone) return nullptr;
        const Plane& here = result_.planes_[edge.surface];
        const Plane& there = result_.planes_[found->second.surface];
        const bool is_convex = is_behind(outlines_[edge.surface], there) &&
                               is_behind(outlines_[found->second.surface], here) &&
                               here.normal.cross(there.normal).norm() > clearly;
        return is_convex ? &found->second : nullptr;
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
        if (gap.norm() > static_cast<double>(open.size()) * step_ || !(twice_area.norm() > 0)) return std::nullopt;
        const Vector3d normal = twice_area.normalized();
        Plane plane{normal, normal.dot(open.front().from)};
        for (const Edge& edge : open) {
            if (normal.dot(edge.from) < plane.offset - result_.room_) return std::nullopt;
        }
        return plane;
    }

    std::optional<Body> body_of(const std::vector<std::size_t>& sides) {
        if (sides.size() < 3) return std::nullopt;
        Body body;
        std::vector<Edge> open;
        Eigen::AlignedBox3d box;
        for (const std::size_t side : sides) {
            body.planes.push_back(result_.planes_[side]);
            const ConvexPolygon& outline = outlines_[side];
            for (std::size_t k = 0; k < outline.size(); ++k) {
                box.extend(outline[k]);
                const std::pair ends(name_of(outline[k]), name_of(next_corner(outline, k)));
                const Edge& edge = edges_.at(ends);
                const Edge* other = across(ends, edge);
                if (other == nullptr || root(other->surface) != root(side)) open.push_back(edge);
            }
        }
        body.size = box.sizes().maxCoeff();
        if (!open.empty()) {
            const auto missing = missing_side(open);
            if (!missing) return std::nullopt;
            body.planes.push_back(*missing);
            body.misses_one = true;
        }
        for (const std::size_t side : sides) {
            const auto is_in_front_of = [&](const Plane& plane) { return !is_behind(outlines_[side], plane); };
            if (std::any_of(body.planes.begin(), body.planes.end(), is_in_front_of)) return std::nullopt;
        }
        return body;
    }
};

ConvexBodies::ConvexBodies(const std::vector<Surface>& surfaces) {
    Finder(*this, surfaces);
}

std::optional<std::uint32_t> ConvexBodies::of(std::size_t surface) const {
    return body_of_[surface] == no_body ? std::nullopt : std::optional(body_of_[surface]);
}

bool ConvexBodies::is_met_before(std::size_t side, std::span<const Vector3d> from) const {
    const Body& body = bodies_[body_of_[side]];
    const auto all_behind = [&](const Plane& plane) {
        return std::all_of(from.begin(), from.end(),
                           [&](const Vector3d& v) { return plane.normal.dot(v) <= plane.offset + room_; });
    };
    // What lies in the plane of a side has that side at its back, not before it; a common edge does not matter.
    const auto all_in_front = [&](const Plane& plane) {
        double lowest = std::numeric_limits<double>::max();
        double highest = std::numeric_limits<double>::lowest();
        for (const Vector3d& v : from) {
            lowest = std::min(lowest, plane.normal.dot(v) - plane.offset);
            highest = std::max(highest, plane.normal.dot(v) - plane.offset);
        }
        return lowest >= -room_ && highest > clearly * body.size;
    };
    const std::span<const Plane> sides = body.sides();
    return all_behind(planes_[side]) && (!body.misses_one || all_behind(body.planes.back())) &&
           std::any_of(sides.begin(), sides.end(), all_in_front);
}

bool ConvexBodies::hides_all(std::uint32_t body, std::span<const Vector3d> from, std::span<const Vector3d> to) const {
    const std::vector<Plane>& planes = bodies_[body].planes;
    const double margin = clearly * bodies_[body].size;
    const auto is_outside = [&](std::span<const Vector3d> polygon) {
        return std::any_of(planes.begin(), planes.end(), [&](const Plane& plane) {
            return std::all_of(polygon.begin(), polygon.end(),
                               [&](const Vector3d& v) { return plane.normal.dot(v) > plane.offset + margin; });
        });
    };
    if (!is_outside(from) || !is_outside(to)) return false;
    // The ends of lines from one place that a convex body hides form a convex set, and so do the beginnings of lines to
    // one place. Therefore the lines between corners decide for all lines.
    const auto crosses = [&](const Vector3d& begin, const Vector3d& end) {
        double enters = 0;
        double leaves = 1;
        for (const Plane& plane : planes) {
            const double before = plane.normal.dot(begin) - plane.offset;
            const double after = plane.normal.dot(end) - plane.offset;
            if (before >= 0 && after >= 0) return false;
            if (before > 0) enters = std::max(enters, before / (before - after));
            if (after > 0) leaves = std::min(leaves, before / (before - after));
        }
        return leaves - enters > clearly;
    };
    return std::all_of(from.begin(), from.end(), [&](const Vector3d& begin) {
        return std::all_of(to.begin(), to.end(), [&](const Vector3d& end) { return crosses(begin, end); });
    });
}

}  // namespace ff
