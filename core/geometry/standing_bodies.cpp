#include "core/geometry/standing_bodies.hpp"

#include "core/geometry/box_tree.hpp"
#include "core/geometry/ear_clipping.hpp"
#include "core/geometry/place_numbers.hpp"
#include "core/geometry/surface_map.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace ff {
namespace {

using Eigen::Vector3d;
using Edge = std::pair<std::uint32_t, std::uint32_t>;  // numbers of its ends
using LidPlane = Eigen::Hyperplane<double, 3>;

std::vector<ConvexPolygon> triangles_of(const ConvexPolygon& polygon) {
    std::vector<ConvexPolygon> triangles;
    for (const auto& [a, b, c] : clip_ears(polygon)) triangles.push_back({polygon[a], polygon[b], polygon[c]});
    return triangles;
}

/// A simple polygon, counter-clockwise around its normal, in as few convex parts as are easily found.
std::vector<ConvexPolygon> convex_parts(const ConvexPolygon& polygon, const Vector3d& normal) {
    const std::size_t n = polygon.size();
    for (std::size_t k = 0; k < n; ++k) {
        const Vector3d along = polygon[(k + 1) % n] - polygon[k];
        const Vector3d next = polygon[(k + 2) % n] - polygon[(k + 1) % n];
        constexpr double rounding = 1e-9;
        if (along.cross(next).dot(normal) < -rounding * along.norm() * next.norm()) return triangles_of(polygon);
    }
    return {polygon};
}

class Finder {
  public:
    Finder(const Scene& scene, double gap);
    StandingBodies find();

  private:
    const Scene& scene_;
    double gap_;
    PlaceNumbers number_;
    std::vector<ConvexPolygon> polygons_;            ///< outline of each surface; empty for a round one
    std::vector<std::vector<std::uint32_t>> rings_;  ///< numbers of their corners
    std::vector<Vector3d> places_;                   ///< places of corners, by number
    std::map<Edge, std::vector<std::uint32_t>> at_edge_;
    std::vector<Eigen::AlignedBox3d> boxes_;
    std::vector<std::uint32_t> body_;  ///< number of the body that each surface belongs to, once rims are looked for
    StandingBodies result_;

    static Edge edge_between(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }
    /// How far a surface reaches along a normal from a place.
    [[nodiscard]] Extent heights(std::uint32_t surface, const Vector3d& normal, const Vector3d& place) const {
        const Extent reach = extent(scene_.surfaces[surface], normal);
        return {reach.low - normal.dot(place), reach.high - normal.dot(place)};
    }
    [[nodiscard]] bool is_level(std::uint32_t surface, const Vector3d& normal, const Vector3d& place) const {
        const Extent reach = heights(surface, normal, place);
        return reach.low >= -gap_ && reach.high <= gap_;
    }
    /// Whether no part of a body is behind a plane.
    [[nodiscard]] bool is_before(const std::vector<std::uint32_t>& body, const Vector3d& normal,
                                 const Vector3d& place) const {
        return std::ranges::all_of(body, [&](std::uint32_t part) { return heights(part, normal, place).low >= -gap_; });
    }
    [[nodiscard]] bool rises(std::uint32_t surface, const Vector3d& normal, const Vector3d& place) const {
        const Extent reach = heights(surface, normal, place);
        return reach.low >= -gap_ && reach.high > gap_;
    }
    /// Whether a surface runs through an edge in this direction, counter-clockwise around its normal.
    [[nodiscard]] bool runs(std::uint32_t surface, std::uint32_t from, std::uint32_t to) const {
        const auto& ring = rings_[surface];
        for (std::size_t k = 0; k < ring.size(); ++k) {
            if (ring[k] == from && next_corner(ring, k) == to) return true;
        }
        return false;
    }
    /// Whether another surface at an edge is the back of this one, as in a plate with two sides.
    [[nodiscard]] bool has_back(std::uint32_t surface, const std::vector<std::uint32_t>& at_edge) const;
    /// Whether the body of a bottom rises at all of its edges, but those between parts of the bottom. Where each of its
    /// sides has a back, and the ground ends there too, bottom and ground are a plate of a shell with two sides.
    [[nodiscard]] bool is_bottom_on(std::uint32_t bottom, std::uint32_t ground) const;
    void find_bottoms(const BoxTree& tree);
    void find_rims(const BoxTree& tree);
    /// A convex part of a rim, and a surface that it lies on.
    struct Cover {
        std::uint32_t ground = 0;
        ConvexPolygon polygon;
    };
    /// The plane polygons that close a rim: itself, or one in each of the two or three planes of other surfaces in
    /// which its edges lie, as in a corner of a room. None where it is not understood.
    [[nodiscard]] std::vector<ConvexPolygon> lids(const ConvexPolygon& rim, const std::vector<std::uint32_t>& body,
                                                  const BoxTree& tree) const;
    /// The surfaces that all of a body's lid lies on and that face the body; empty where it does not stand in this way.
    [[nodiscard]] std::vector<Cover> covered_by_lid(const ConvexPolygon& lid, const std::vector<std::uint32_t>& body,
                                                    const BoxTree& tree) const;
    /// Surfaces that touch at edges have the same number.
    [[nodiscard]] std::vector<std::uint32_t> bodies() const;
    void take_away(std::uint32_t surface, ConvexPolygon polygon);
};

Finder::Finder(const Scene& scene, double gap)
    : scene_(scene), gap_(gap), number_(gap), boxes_(boxes_around(scene.surfaces)) {
    for (std::uint32_t i = 0; i < scene.surfaces.size(); ++i) {
        polygons_.push_back(corners(scene.surfaces[i].shape));
        std::vector<std::uint32_t>& ring = rings_.emplace_back();
        for (const Vector3d& corner : polygons_[i]) {
            ring.push_back(number_(corner));
            if (ring.back() == places_.size()) places_.push_back(corner);
        }
        // Corners of a parallelogram need not be in the order that the normal asks for.
        if (!ring.empty() && twice_area(polygons_[i]).dot(scene.surfaces[i].normal) < 0) {
            std::reverse(ring.begin(), ring.end());
            std::reverse(polygons_[i].begin(), polygons_[i].end());
        }
        for (std::size_t k = 0; k < ring.size(); ++k)
            at_edge_[edge_between(ring[k], next_corner(ring, k))].push_back(i);
    }
}

void Finder::take_away(std::uint32_t surface, ConvexPolygon polygon) {
    const Surface& from = scene_.surfaces[surface];
    if (from.grid != undivided) return;
    turn_around(polygon, from.normal);
    if (is_sliver(common_part(polygons_[surface], polygon, from.normal), gap_)) return;
    if (result_.left.empty()) result_.left.resize(scene_.surfaces.size());
    auto& left = result_.left[surface];
    if (!left) left = std::vector<ConvexPolygon>{polygons_[surface]};
    *left = without(*left, polygon, from.normal, gap_);
}

bool Finder::has_back(std::uint32_t surface, const std::vector<std::uint32_t>& at_edge) const {
    const Vector3d& normal = scene_.surfaces[surface].normal;
    return std::any_of(at_edge.begin(), at_edge.end(), [&](std::uint32_t other) {
        return scene_.surfaces[other].normal.dot(normal) < 0 && is_level(other, normal, polygons_[surface].front());
    });
}

bool Finder::is_bottom_on(std::uint32_t bottom, std::uint32_t ground) const {
    const Vector3d& normal = scene_.surfaces[ground].normal;
    const Vector3d& place = polygons_[ground].front();
    const auto& ring = rings_[bottom];
    bool any = false;
    bool is_plate = true;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const auto& here = at_edge_.at(edge_between(ring[k], next_corner(ring, k)));
        const bool ground_ends = std::any_of(here.begin(), here.end(), [&](std::uint32_t other) {
            return scene_.surfaces[other].face == scene_.surfaces[ground].face && is_level(other, normal, place) &&
                   scene_.surfaces[other].normal.dot(normal) > 0;
        });
        bool side = false;
        for (const std::uint32_t other : here) {
            // A side of the same body runs through the edge the other way; a wall of a room beyond does not.
            if (other == bottom || !rises(other, normal, place) || !runs(other, next_corner(ring, k), ring[k]))
                continue;
            side = true;
            is_plate = is_plate && ground_ends && has_back(other, here);
        }
        const bool more_of_it = std::any_of(here.begin(), here.end(), [&](std::uint32_t other) {
            return other != bottom && is_level(other, normal, place) && scene_.surfaces[other].normal.dot(normal) < 0;
        });
        if (!side && !more_of_it) return false;
        any = any || side;
    }
    return any && !is_plate;
}

void Finder::find_bottoms(const BoxTree& tree) {
    for (std::uint32_t ground = 0; ground < polygons_.size(); ++ground) {
        if (polygons_[ground].empty()) continue;
        const Vector3d& normal = scene_.surfaces[ground].normal;
        tree.within(boxes_[ground], gap_, [&](std::uint32_t bottom) {
            if (polygons_[bottom].empty() || scene_.surfaces[bottom].normal.dot(normal) >= 0 ||
                !is_level(bottom, normal, polygons_[ground].front()) || !is_bottom_on(bottom, ground))
                return;
            take_away(ground, polygons_[bottom]);
            take_away(bottom, polygons_[ground]);
        });
    }
}

std::vector<std::uint32_t> Finder::bodies() const {
    std::vector<std::uint32_t> body(polygons_.size());
    std::iota(body.begin(), body.end(), std::uint32_t{0});
    const auto root = [&](std::uint32_t at) {
        while (body[at] != at) at = body[at] = body[body[at]];
        return at;
    };
    for (const auto& [edge, surfaces] : at_edge_) {
        for (const std::uint32_t other : surfaces) body[root(other)] = root(surfaces.front());
    }
    for (std::uint32_t i = 0; i < body.size(); ++i) body[i] = root(i);
    return body;
}

/// A closed walk along free edges, which are removed; empty where one of them is a dead end.
std::vector<std::uint32_t> walk(std::map<std::uint32_t, std::uint32_t>& edges) {
    std::vector<std::uint32_t> rim;
    const std::uint32_t first = edges.begin()->first;
    std::uint32_t at = first;
    do {
        const auto edge = edges.find(at);
        if (edge == edges.end()) return {};
        rim.push_back(at);
        at = edge->second;
        edges.erase(edge);
    } while (at != first);
    return rim;
}

/// The corner that three planes have in common; empty where two of them are parallel.
std::optional<Vector3d> common_corner(const std::vector<LidPlane>& planes) {
    if (planes.size() != 3) return std::nullopt;
    Eigen::Matrix3d normals;
    Vector3d distances;
    for (Eigen::Index i = 0; i < 3; ++i) {
        normals.row(i) = planes[static_cast<std::size_t>(i)].normal();
        distances[i] = -planes[static_cast<std::size_t>(i)].offset();
    }
    const auto solver = normals.fullPivLu();
    return solver.isInvertible() ? std::optional<Vector3d>(solver.solve(distances)) : std::nullopt;
}

std::vector<ConvexPolygon> Finder::lids(const ConvexPolygon& rim, const std::vector<std::uint32_t>& body,
                                        const BoxTree& tree) const {
    const auto lies_in = [&](const LidPlane& plane, const Vector3d& place) { return plane.absDistance(place) <= gap_; };
    const auto count_in = [&](const LidPlane& plane) {
        return std::count_if(rim.begin(), rim.end(), [&](const Vector3d& corner) { return lies_in(plane, corner); });
    };
    const LidPlane own(twice_area(rim).normalized(), rim.front());
    if (count_in(own) == std::ssize(rim)) return {rim};
    std::vector<LidPlane> planes;
    for (std::size_t k = 0; k < rim.size(); ++k) {
        const std::array<Vector3d, 2> edge{rim[k], next_corner(rim, k)};
        const auto has_edge = [&](const LidPlane& plane) { return lies_in(plane, edge[0]) && lies_in(plane, edge[1]); };
        if (std::any_of(planes.begin(), planes.end(), has_edge)) continue;
        std::optional<LidPlane> found;
        tree.within(box_around(edge), gap_, [&](std::uint32_t other) {
            if (polygons_[other].empty() || body_[other] == body_[body.front()]) return;
            const LidPlane plane(scene_.surfaces[other].normal, polygons_[other].front());
            if (has_edge(plane) && count_in(plane) > 2 && is_before(body, plane.normal(), edge[0])) found = plane;
        });
        if (!found) return {};
        planes.push_back(*found);
    }
    if (planes.size() > 3) return {};
    const auto closed_with = [&](const std::optional<Vector3d>& corner) {
        std::vector<ConvexPolygon> all;
        Vector3d missing = twice_area(rim);  // as vectors, areas of polygons that close a rim have the sum of its own
        for (const LidPlane& plane : planes) {
            ConvexPolygon& lid = all.emplace_back();
            for (std::size_t k = 0; k < rim.size(); ++k) {
                if (!lies_in(plane, rim[k])) continue;
                lid.push_back(rim[k]);
                if (corner && !lies_in(plane, next_corner(rim, k))) lid.push_back(*corner);
            }
            missing -= twice_area(lid);
        }
        return missing.norm() <= 4 * gap_ * length_around(rim) ? all : std::vector<ConvexPolygon>();
    };
    // In a corner of a room, all lids have the place where the three planes meet, which the rim has not.
    const auto all = closed_with(std::nullopt);
    const auto corner = common_corner(planes);
    return all.empty() && corner ? closed_with(corner) : all;
}

std::vector<Finder::Cover> Finder::covered_by_lid(const ConvexPolygon& lid, const std::vector<std::uint32_t>& body,
                                                  const BoxTree& tree) const {
    const Vector3d normal = twice_area(lid).normalized();  // towards a body whose sides face outwards
    const Eigen::AlignedBox3d box = box_around(lid);
    const auto is_above = [&](std::uint32_t part) { return rises(part, normal, lid.front()); };
    if (!is_before(body, normal, lid.front()) || std::none_of(body.begin(), body.end(), is_above)) return {};
    std::vector<Cover> covers;
    double covered = 0;
    for (const ConvexPolygon& part : convex_parts(lid, normal)) {
        tree.within(box, gap_, [&](std::uint32_t ground) {
            if (polygons_[ground].empty() || scene_.surfaces[ground].normal.dot(normal) <= 0 ||
                !is_level(ground, normal, lid.front()))
                return;
            const double common = polygon_area(common_part(polygons_[ground], part, normal));
            if (common > 0) covers.push_back({ground, part});
            covered += common;
        });
    }
    // The uncovered part is at most what rounding leaves along the lid and between the surfaces beneath it.
    constexpr double rounding = 1e-6;
    const double missing = std::max(rounding * polygon_area(lid), gap_ * (length_around(lid) + box.diagonal().norm()));
    return covered >= polygon_area(lid) - missing ? covers : std::vector<Cover>();
}

void Finder::find_rims(const BoxTree& tree) {
    body_ = bodies();
    // The beginning and end, for each body, of the edges that only one surface has, in the direction of its outline.
    std::map<std::uint32_t, std::map<std::uint32_t, std::uint32_t>> free_edges;
    std::map<std::uint32_t, std::vector<std::uint32_t>> members;
    for (std::uint32_t i = 0; i < rings_.size(); ++i) {
        members[body_[i]].push_back(i);
        for (std::size_t k = 0; k < rings_[i].size(); ++k) {
            const std::uint32_t from = rings_[i][k];
            const std::uint32_t to = next_corner(rings_[i], k);
            if (at_edge_.at(edge_between(from, to)).size() == 1) free_edges[body_[i]].emplace(from, to);
        }
    }
    for (auto& [which, edges] : free_edges) {
        std::vector<Cover> covers;
        bool is_closed = true;  // a body that is open anywhere lets light in
        while (!edges.empty() && is_closed) {
            ConvexPolygon rim;
            for (const std::uint32_t corner : walk(edges)) rim.push_back(places_[corner]);
            const auto closing = rim.empty() ? std::vector<ConvexPolygon>() : lids(rim, members[which], tree);
            is_closed = !closing.empty();
            for (const ConvexPolygon& lid : closing) {
                const auto more = covered_by_lid(lid, members[which], tree);
                is_closed = is_closed && !more.empty();
                covers.insert(covers.end(), more.begin(), more.end());
            }
        }
        if (!is_closed) continue;
        for (const Cover& cover : covers) take_away(cover.ground, cover.polygon);
    }
}

StandingBodies Finder::find() {
    const BoxTree tree(boxes_);
    find_bottoms(tree);
    find_rims(tree);
    return std::move(result_);
}

}  // namespace

StandingBodies standing_bodies(const Scene& scene, double gap) {
    if (!(gap > 0)) return {};
    return Finder(scene, gap).find();
}

}  // namespace ff
