#include "core/geometry/standing_bodies.hpp"

#include "core/geometry/box_tree.hpp"
#include "core/geometry/ear_clipping.hpp"
#include "core/geometry/outlines.hpp"
#include "core/geometry/rim.hpp"
#include "core/geometry/surface_map.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace ff {
namespace {

using Eigen::Vector3d;

/// An edge at which a side of a body has no partner, in the direction of the side's outline.
struct FreeEdge {
    std::uint32_t end = 0;   ///< number of the corner at its end
    std::uint32_t side = 0;  ///< the surface
};
/// Free edges of a body, by the numbers of their beginnings.
using FreeEdges = std::map<std::uint32_t, FreeEdge>;
/// Corners in order around an opening, each with the side whose edge begins there.
using Opening = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

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
    Finder(const Scene& scene, double gap)
        : scene_(scene), gap_(gap), outlines_(scene, gap), boxes_(boxes_around(scene.surfaces)) {}
    StandingBodies find();

  private:
    const Scene& scene_;
    double gap_;
    Outlines outlines_;
    std::vector<Eigen::AlignedBox3d> boxes_;
    std::vector<std::uint32_t> body_;    ///< number of the body that each surface belongs to, once rims are looked for
    std::set<std::uint32_t> is_closed_;  ///< bodies with rims that are closed by what they stand on or against
    StandingBodies result_;

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
    /// Whether another surface at an edge is the back of this one, as in a plate with two sides.
    [[nodiscard]] bool has_back(std::uint32_t surface, const std::vector<std::uint32_t>& at_edge) const;
    /// Whether all sides at a rim have backs there, as in a shell with two sides, which encloses what it stands on.
    [[nodiscard]] bool is_of_plates(const Opening& rim) const;
    /// Whether the body of a bottom rises at all of its edges, but those between parts of the bottom, and those against
    /// a wall. Where each of its sides has a back, and the ground ends there too, bottom and ground are a plate of a
    /// shell with two sides.
    [[nodiscard]] bool is_bottom_on(std::uint32_t bottom, std::uint32_t ground) const;
    void find_bottoms(const BoxTree& tree);
    void find_rims(const BoxTree& tree);
    /// A convex part of a lid, and a surface that it lies on.
    struct Cover {
        std::uint32_t ground = 0;
        ConvexPolygon polygon;
        double area = 0;  ///< of the common part
    };
    using Members = std::map<std::uint32_t, std::vector<std::uint32_t>>;  ///< surfaces of bodies
    /// Whether all surfaces that bound a body together are covered: walls of a room that face the wrong way would be a
    /// body that fills the room.
    [[nodiscard]] bool covers_all_of_a_body(const std::vector<Cover>& covers, const Members& members) const;
    /// The plane polygons that close a rim: itself, or one in each plane of other surfaces in which its edges lie, as
    /// in a corner of a room. None where it is not understood.
    [[nodiscard]] std::vector<ConvexPolygon> lids(const Opening& around, const std::vector<std::uint32_t>& body,
                                                  const BoxTree& tree) const;
    /// The surfaces that all of a body's lid lies on and that face the body; empty where it does not stand in this way.
    [[nodiscard]] std::vector<Cover> covered_by_lid(const ConvexPolygon& lid, const std::vector<std::uint32_t>& body,
                                                    const BoxTree& tree) const;
    void take_away(std::uint32_t surface, ConvexPolygon polygon);
};

void Finder::take_away(std::uint32_t surface, ConvexPolygon polygon) {
    const Surface& from = scene_.surfaces[surface];
    if (from.grid != undivided) return;
    turn_around(polygon, from.normal);
    if (is_sliver(common_part(outlines_.polygon(surface), polygon, from.normal), gap_)) return;
    if (result_.left.empty()) result_.left.resize(scene_.surfaces.size());
    auto& left = result_.left[surface];
    if (!left) left = std::vector<ConvexPolygon>{outlines_.polygon(surface)};
    *left = without(*left, polygon, from.normal, gap_);
}

bool Finder::has_back(std::uint32_t surface, const std::vector<std::uint32_t>& at_edge) const {
    const Vector3d& normal = scene_.surfaces[surface].normal;
    return std::any_of(at_edge.begin(), at_edge.end(), [&](std::uint32_t other) {
        return scene_.surfaces[other].normal.dot(normal) < 0 &&
               is_level(other, normal, outlines_.polygon(surface).front());
    });
}

bool Finder::is_of_plates(const Opening& rim) const {
    for (std::size_t k = 0; k < rim.size(); ++k) {
        if (!has_back(rim[k].second, outlines_.at_edge(rim[k].first, next_corner(rim, k).first))) return false;
    }
    return true;
}

bool Finder::is_bottom_on(std::uint32_t bottom, std::uint32_t ground) const {
    const Vector3d& normal = scene_.surfaces[ground].normal;
    const Vector3d& place = outlines_.polygon(ground).front();
    const auto& ring = outlines_.ring(bottom);
    bool any = false;
    bool is_plate = true;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const auto& here = outlines_.at_edge(ring[k], next_corner(ring, k));
        const bool ground_ends = std::any_of(here.begin(), here.end(), [&](std::uint32_t other) {
            return scene_.surfaces[other].face == scene_.surfaces[ground].face && is_level(other, normal, place) &&
                   scene_.surfaces[other].normal.dot(normal) > 0;
        });
        bool side = false;
        for (const std::uint32_t other : here) {
            // A side of the same body runs through the edge the other way; a wall of a room beyond does not.
            if (other == bottom || !rises(other, normal, place) ||
                !outlines_.runs(other, next_corner(ring, k), ring[k]))
                continue;
            side = true;
            is_plate = is_plate && ground_ends && has_back(other, here);
        }
        const bool more_of_it = std::any_of(here.begin(), here.end(), [&](std::uint32_t other) {
            return other != bottom && is_level(other, normal, place) && scene_.surfaces[other].normal.dot(normal) < 0;
        });
        const bool is_against_a_wall =
            is_closed_.contains(body_[bottom]) && !outlines_.partner_at(ring[k], next_corner(ring, k), bottom);
        if (!side && !more_of_it && !is_against_a_wall) return false;
        any = any || side;
    }
    return any && !is_plate;
}

void Finder::find_bottoms(const BoxTree& tree) {
    for (std::uint32_t ground = 0; ground < outlines_.size(); ++ground) {
        if (outlines_.polygon(ground).empty()) continue;
        const Vector3d& normal = scene_.surfaces[ground].normal;
        tree.within(boxes_[ground], gap_, [&](std::uint32_t bottom) {
            if (outlines_.polygon(bottom).empty() || scene_.surfaces[bottom].normal.dot(normal) >= 0 ||
                !is_level(bottom, normal, outlines_.polygon(ground).front()) || !is_bottom_on(bottom, ground))
                return;
            take_away(ground, outlines_.polygon(bottom));
            take_away(bottom, outlines_.polygon(ground));
        });
    }
}

/// A closed walk along free edges, which are removed; empty where one of them is a dead end.
Opening walk(FreeEdges& edges) {
    Opening rim;
    const std::uint32_t first = edges.begin()->first;
    std::uint32_t at = first;
    do {
        const auto edge = edges.find(at);
        if (edge == edges.end()) return {};
        rim.emplace_back(at, edge->second.side);
        at = edge->second.end;
        edges.erase(edge);
    } while (at != first);
    return rim;
}

std::vector<ConvexPolygon> Finder::lids(const Opening& around, const std::vector<std::uint32_t>& body,
                                        const BoxTree& tree) const {
    ConvexPolygon rim;
    for (const auto& [corner, side] : around) rim.push_back(outlines_.place(corner));
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
        const std::uint32_t own_side = around[k].second;
        std::optional<LidPlane> found;
        std::ptrdiff_t most = 0;  // corners of the rim in one plane
        tree.within(box_around(edge), gap_, [&](std::uint32_t other) {
            if (outlines_.polygon(other).empty() || body_[other] == body_[body.front()]) return;
            const LidPlane plane(scene_.surfaces[other].normal, outlines_.polygon(other).front());
            // A neighbor may go on where a side of the body ends, in the same plane, and face the body.
            if (!has_edge(plane) || count_in(plane) <= most || is_level(own_side, plane.normal(), edge[0]) ||
                !is_before(body, plane.normal(), edge[0]))
                return;
            most = count_in(plane);
            found = plane;
        });
        if (!found) return {};
        planes.push_back(*found);
    }
    return closing_polygons(rim, planes, gap_);
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
            if (outlines_.polygon(ground).empty() || scene_.surfaces[ground].normal.dot(normal) <= 0 ||
                !is_level(ground, normal, lid.front()))
                return;
            const double common = polygon_area(common_part(outlines_.polygon(ground), part, normal));
            if (common > 0) covers.push_back({ground, part, common});
            covered += common;
        });
    }
    // The uncovered part is at most what rounding leaves along the lid and between the surfaces beneath it.
    constexpr double rounding = 1e-6;
    const double missing = std::max(rounding * polygon_area(lid), gap_ * (length_around(lid) + box.diagonal().norm()));
    return covered >= polygon_area(lid) - missing ? covers : std::vector<Cover>();
}

bool Finder::covers_all_of_a_body(const std::vector<Cover>& covers, const Members& members) const {
    std::map<std::uint32_t, double> covered;
    for (const Cover& cover : covers) covered[body_[cover.ground]] += cover.area;
    return std::ranges::any_of(covered, [&](const auto& body) {
        double whole = 0;
        for (const std::uint32_t side : members.at(body.first)) whole += polygon_area(outlines_.polygon(side));
        constexpr double rounding = 1e-6;
        return body.second >= (1 - rounding) * whole;
    });
}

void Finder::find_rims(const BoxTree& tree) {
    body_ = outlines_.bodies();
    std::map<std::uint32_t, FreeEdges> free_edges;
    Members members;
    for (std::uint32_t i = 0; i < outlines_.size(); ++i) {
        members[body_[i]].push_back(i);
        for (std::size_t k = 0; k < outlines_.ring(i).size(); ++k) {
            const std::uint32_t from = outlines_.ring(i)[k];
            const std::uint32_t to = next_corner(outlines_.ring(i), k);
            if (!outlines_.partner_at(from, to, i)) free_edges[body_[i]].emplace(from, FreeEdge{to, i});
        }
    }
    for (auto& [which, edges] : free_edges) {
        std::vector<Cover> covers;
        bool is_closed = true;  // a body that is open anywhere lets light in
        while (!edges.empty() && is_closed) {
            const Opening rim = walk(edges);
            const auto closing = rim.empty() ? std::vector<ConvexPolygon>() : lids(rim, members[which], tree);
            is_closed = !closing.empty() && !is_of_plates(rim);
            for (const ConvexPolygon& lid : closing) {
                const auto more = covered_by_lid(lid, members[which], tree);
                is_closed = is_closed && !more.empty();
                covers.insert(covers.end(), more.begin(), more.end());
            }
        }
        if (!is_closed || covers_all_of_a_body(covers, members)) continue;
        is_closed_.insert(which);
        for (const Cover& cover : covers) take_away(cover.ground, cover.polygon);
    }
}

StandingBodies Finder::find() {
    const BoxTree tree(boxes_);
    find_rims(tree);
    find_bottoms(tree);
    return std::move(result_);
}

}  // namespace

StandingBodies standing_bodies(const Scene& scene, double gap) {
    if (!(gap > 0)) return {};
    return Finder(scene, gap).find();
}

}  // namespace ff
