#include "studies/form_factors/cells/blocked_pair.hpp"

#include "core/geometry/surface_map.hpp"

#include <Eigen/Geometry>
#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace ff::studies::form_factors {
namespace {

using Eigen::Vector3d;

/// Lengths that differ by less, as a share of the pair's size, are taken for equal.
constexpr double same_length = 1e-10;

/// So many corners need no memory of their own.
constexpr std::size_t few_corners = 16;

ConvexPolygon moved(const Surface& surface, const Vector3d& origin) {
    ConvexPolygon result = outline(surface);
    for (Vector3d& corner : result) corner -= origin;
    return result;
}

ConvexPolygon in_front_of(const ConvexPolygon& polygon, const Surface& surface, const Vector3d& origin) {
    return clipped(polygon, surface.normal, surface.normal.dot(corners(surface.shape).front() - origin));
}

/// On which side of its plane all of the source lies: 1 in front, -1 behind, 0 on both sides.
int side_of_source(const BlockedPair& pair, const ConvexPolygon& blocker) {
    const Vector3d normal = twice_area(blocker).normalized();
    bool front = true;
    bool behind = true;
    for (const Vector3d& corner : pair.source) {
        const double height = normal.dot(corner - blocker.front());
        front = front && height >= -same_length * pair.size;
        behind = behind && height <= same_length * pair.size;
    }
    return front ? 1 : behind ? -1 : 0;
}

/// Whether some plane through a line has both ends on one side, so that no line between them crosses it.
bool is_passed_by(const BlockedPair& pair, const Vector3d& a, const Vector3d& b) {
    const Vector3d along = (b - a).normalized();
    const Vector3d across = perpendicular(along);
    const Vector3d up = along.cross(across);
    boost::container::small_vector<Eigen::Vector2d, few_corners> seen;  // along the line
    for (const ConvexPolygon* end : {&pair.source, &pair.target}) {
        for (const Vector3d& corner : *end) seen.emplace_back(across.dot(corner - a), up.dot(corner - a));
    }
    const double room = same_length * pair.size;
    return std::any_of(seen.begin(), seen.end(), [&](const Eigen::Vector2d& through) {
        const double length = through.norm();
        if (length < room) return false;
        bool left = true;
        bool right = true;
        for (const Eigen::Vector2d& other : seen) {
            const double side = (through.x() * other.y() - through.y() * other.x()) / length;
            left = left && side >= -room;
            right = right && side <= room;
            // A plane that holds places on both sides of the line parts nothing.
            const bool is_opposite = std::abs(side) <= room && through.dot(other) < -room * length;
            if (is_opposite || (!left && !right)) return false;
        }
        return true;
    });
}

}  // namespace

BlockedPair::BlockedPair(const Surface& from, const Surface& to, const std::vector<Blocker>& between)
    : origin(middle(from)), source_normal(from.normal) {
    source = in_front_of(moved(from, origin), to, origin);
    target = in_front_of(moved(to, origin), from, origin);
    if (source.empty() || target.empty()) return;
    for (const ConvexPolygon* end : {&source, &target}) {
        for (const Vector3d& corner : *end) size = std::max(size, corner.norm());
    }
    for (std::uint32_t b = 0; b < between.size(); ++b) {
        ConvexPolygon part = in_front_of(in_front_of(moved(*between[b].surface, origin), from, origin), to, origin);
        if (part.empty() || !(polygon_area(part) > same_length * same_length * size * size)) continue;
        blockers.push_back(std::move(part));
        indices.push_back(b);
    }
}

std::vector<RimEdge> rim_of(const BlockedPair& pair) {
    struct Edge {
        RimEdge edge;
        int side;
        bool inner = false;
    };
    std::vector<Edge> edges;
    edges.reserve(4 * pair.blockers.size());
    for (std::size_t k = 0; k < pair.blockers.size(); ++k) {
        const ConvexPolygon& blocker = pair.blockers[k];
        const int side = side_of_source(pair, blocker);
        for (std::size_t c = 0; c < blocker.size(); ++c) {
            const Vector3d& a = blocker[c];
            const Vector3d& b = next_corner(blocker, c);
            if ((b - a).norm() > same_length * pair.size) edges.push_back({{a, b, k}, side});
        }
    }
    // Edges that are the same have the same place in any direction: only those next to each other there are compared.
    const double room = same_length * pair.size;
    const auto is_same = [room](const Vector3d& a, const Vector3d& b) { return (a - b).squaredNorm() <= room * room; };
    const Vector3d askew(1, 0.7548776662466927, 0.5698402909980532);  // few edges are abreast in this direction
    std::vector<std::pair<double, Edge*>> by_place;
    by_place.reserve(edges.size());
    for (Edge& each : edges) by_place.emplace_back(askew.dot(each.edge.a + each.edge.b), &each);
    std::sort(by_place.begin(), by_place.end());
    for (std::size_t i = 0; i < by_place.size(); ++i) {
        Edge& one = *by_place[i].second;
        for (std::size_t j = i; j-- > 0 && by_place[i].first - by_place[j].first <= 4 * room;) {
            Edge& other = *by_place[j].second;
            const bool against = is_same(one.edge.a, other.edge.b) && is_same(one.edge.b, other.edge.a);
            const bool along = is_same(one.edge.a, other.edge.a) && is_same(one.edge.b, other.edge.b);
            const int turned = against ? 1 : along ? -1 : 0;
            if (turned != 0 && one.side != 0 && one.side == turned * other.side) one.inner = other.inner = true;
        }
    }
    std::vector<RimEdge> rim;
    for (const Edge& each : edges) {
        if (!each.inner && !is_passed_by(pair, each.edge.a, each.edge.b)) rim.push_back(each.edge);
    }
    return rim;
}

namespace {

/// Lines on the source.
class Lines {
  public:
    Lines(const BlockedPair& pair, std::size_t most_parts) : pair_(pair), most_parts_(most_parts) {
        for (const Vector3d& corner : pair.source) radius_ = std::max(radius_, corner.norm());
    }

    /// Adds the line in which a plane cuts the source.
    /// @param happens  whether the event that the line stands for is seen somewhere between its two ends
    template <class Happens>
    void add(const Vector3d& p, const Vector3d& normal, const Happens& happens) {
        const Vector3d across = normal - normal.dot(pair_.source_normal) * pair_.source_normal;
        if (!(across.norm() > same_length * normal.norm())) return;
        boost::container::small_vector<double, few_corners> heights;
        for (const Vector3d& corner : pair_.source) heights.push_back(normal.dot(corner - p) / across.norm());
        const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
        const double room = same_length * radius_;
        if (*low > -room || *high < room) return;
        boost::container::small_vector<Vector3d, 2> ends;
        for (std::size_t k = 0; k < heights.size(); ++k) {
            const double before = heights[k];
            const double after = next_corner(heights, k);
            if ((before >= 0) != (after >= 0))
                ends.emplace_back(pair_.source[k] +
                                  (next_corner(pair_.source, k) - pair_.source[k]) * (before / (before - after)));
        }
        if (ends.size() != 2 || !happens(ends[0], ends[1])) return;
        const auto is_same = [&](const Line& line) {
            for (const double sign : {1.0, -1.0}) {
                bool same = true;
                for (std::size_t k = 0; k < heights.size(); ++k)
                    same = same && std::abs(heights[k] - sign * line.heights[k]) <= room;
                if (same) return true;
            }
            return false;
        };
        if (std::none_of(lines_.begin(), lines_.end(), is_same))
            lines_.push_back({ends[0], across.normalized(), {heights.begin(), heights.end()}});
    }

    /// Each line adds at least one part.
    [[nodiscard]] bool are_too_many() const { return lines_.size() >= most_parts_; }

    /// The source cut along the lines; empty where there would be too many parts.
    [[nodiscard]] std::vector<ConvexPolygon> parts() const {
        std::vector<ConvexPolygon> parts{pair_.source};
        for (const Line& line : lines_) {
            std::vector<ConvexPolygon> cut;
            for (const ConvexPolygon& part : parts) {
                const auto height = [&](const Vector3d& corner) {
                    const double exact = line.across.dot(corner - line.place);
                    return std::abs(exact) <= same_length * radius_ ? 0.0 : exact;
                };
                ConvexPolygon above = part_above(part, height);
                ConvexPolygon below = part_above(part, [&](const Vector3d& corner) { return -height(corner); });
                for (ConvexPolygon* half : {&above, &below}) {
                    if (!half->empty() && polygon_area(*half) > 0) cut.push_back(std::move(*half));
                }
            }
            if (cut.size() > most_parts_) return {};
            parts = std::move(cut);
        }
        return parts;
    }

  private:
    struct Line {
        Vector3d place;               ///< a place on the line
        Vector3d across;              ///< direction across the line, in the plane of the source; unit length
        std::vector<double> heights;  ///< heights of the source's corners
    };
    const BlockedPair& pair_;
    std::size_t most_parts_;
    double radius_ = 0;
    std::vector<Line> lines_;
};

/// Where the line from `a` to `b` is crossed, as seen from a place, by the line of sight through `other`: 0 at a, 1 at
/// b.
double crossing(const Vector3d& place, const Vector3d& a, const Vector3d& b, const Vector3d& other) {
    const Vector3d across = (other - place).cross((b - a).cross(other - place));
    const double before = across.dot(a - place);
    const double after = across.dot(b - place);
    return before / (before - after);
}

}  // namespace

std::vector<ConvexPolygon> smooth_parts(const BlockedPair& pair, const std::vector<RimEdge>& rim,
                                        std::size_t most_parts) {
    Lines lines(pair, most_parts);
    const auto always = [](const Vector3d&, const Vector3d&) { return true; };
    const auto add_plane = [&](const Vector3d& a, const Vector3d& b, const Vector3d& other) {
        lines.add(a, (b - a).cross(other - a), [&](const Vector3d& first, const Vector3d& last) {
            const double at_first = crossing(first, a, b, other);
            const double at_last = crossing(last, a, b, other);
            const bool before = at_first < -same_length && at_last < -same_length;
            const bool after = at_first > 1 + same_length && at_last > 1 + same_length;
            return !before && !after;
        });
    };
    for (const ConvexPolygon& blocker : pair.blockers) {
        if (side_of_source(pair, blocker) == 0) lines.add(blocker.front(), twice_area(blocker), always);
    }
    const auto height = [&](const Vector3d& place) {
        return std::abs(pair.source_normal.dot(place - pair.source.front()));
    };
    for (const RimEdge& edge : rim) {
        // A blocker that stands on the source with an edge is seen from its other side beyond that edge.
        if (std::max(height(edge.a), height(edge.b)) <= same_length * pair.size)
            lines.add(edge.a, (edge.b - edge.a).cross(pair.source_normal), always);
        for (const Vector3d& corner : pair.target) add_plane(edge.a, edge.b, corner);
        for (const Vector3d& corner : {edge.a, edge.b}) {
            for (std::size_t k = 0; k < pair.target.size(); ++k)
                add_plane(pair.target[k], next_corner(pair.target, k), corner);
            for (const RimEdge& other : rim) {
                if (other.blocker != edge.blocker) add_plane(other.a, other.b, corner);
            }
        }
        if (lines.are_too_many()) return {};
    }
    return lines.parts();
}

}  // namespace ff::studies::form_factors
