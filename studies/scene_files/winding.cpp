#include "studies/scene_files/orientation.hpp"

#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/place_numbers.hpp"
#include "core/geometry/placement.hpp"
#include "core/geometry/surface_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

namespace ff::studies {
namespace {

using Eigen::Vector3d;

/// A surface that an edge belongs to.
struct Side {
    std::uint32_t low = 0, high = 0;  ///< numbers of the edge's ends; of a circle's centre and its `Rim::tip`
    int face = 0;
    std::uint32_t surface = 0;
    bool forwards = false;   ///< it runs through the edge from `low` to `high`, counter-clockwise around its normal
    std::uint32_t edge = 0;  ///< number of the edge in the surface's outline
    bool round = false;
};

/// A circle that bounds a round surface.
struct Rim {
    Vector3d centre;
    double radius = 0;
    Vector3d axis;  ///< of any length; the surface runs through the circle counter-clockwise around it

    /// Whether the axis points to that half of all directions which names circles.
    bool forwards() const { return axis.dot(Vector3d(0.6180, 0.3249, 0.7159)) > 0; }

    /// A place that, with the centre, tells the circle from others.
    Vector3d tip() const { return centre + (forwards() ? radius : -radius) * axis.normalized(); }
};

std::vector<Rim> rims_of(const Surface& surface) {
    std::vector<Rim> rims;
    if (const auto* disc = std::get_if<Disc>(&surface.shape)) {
        rims = {{disc->centre, disc->outer_radius, surface.normal},
                {disc->centre, disc->inner_radius, -surface.normal}};
    } else if (const auto* wall = std::get_if<Frustum>(&surface.shape)) {
        rims = {{wall->base, wall->base_radius, wall->axis}, {wall->base + wall->axis, wall->top_radius, -wall->axis}};
    } else if (const auto* zone = std::get_if<SphereZone>(&surface.shape)) {
        const auto rim_at = [&](double height, const Vector3d& axis) {
            return Rim{zone->centre + height * zone->radius * zone->axis,
                       zone->radius * std::sqrt(std::max(0.0, 1 - height * height)), axis};
        };
        rims = {rim_at(zone->low, zone->axis), rim_at(zone->high, -zone->axis)};
    }
    std::erase_if(rims, [](const Rim& rim) { return rim.radius == 0; });
    if (!is_flat(surface.shape) && facing(surface.shape) == Facing::inward) {
        for (Rim& rim : rims) rim.axis = -rim.axis;
    }
    return rims;
}

std::vector<Side> sides_of(const Scene& scene) {
    PlaceNumbers number(resolution_of_places *
                        std::max(farthest_coordinate(scene), std::numeric_limits<double>::min()));
    std::vector<Side> sides;
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
        const Surface& surface = scene.surfaces[s];
        if (surface.face < 0) continue;
        numbers.clear();
        for (const Vector3d& corner : outline(surface)) numbers.push_back(number(corner));
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            const auto [low, high] = std::minmax(numbers[k], next_corner(numbers, k));
            sides.push_back({low, high, surface.face, s, numbers[k] == low, static_cast<std::uint32_t>(k)});
        }
        for (const Rim& rim : rims_of(surface))
            sides.push_back({number(rim.centre), number(rim.tip()), surface.face, s, rim.forwards(), 0, true});
    }
    return sides;
}

/// Edges of surfaces: (surface, number of the edge).
using Edges = std::set<std::pair<std::uint32_t, std::uint32_t>>;

/// Calls use(first, second) for edges that exactly two surfaces have. An edge where bodies or fins meet says nothing.
/// @return edges that one surface has alone
template <class Use>
Edges for_each_common_edge(std::vector<Side>& sides, const Use& use) {
    Edges free;
    const auto key = [](const Side& side) { return std::tuple(side.round, side.low, side.high); };
    std::sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) {
        return std::pair(key(a), a.surface) < std::pair(key(b), b.surface);
    });
    for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
        while (end < sides.size() && key(sides[end]) == key(sides[begin])) ++end;
        if (end - begin == 1) free.emplace(sides[begin].surface, sides[begin].edge);
        if (end - begin == 2) use(sides[begin], sides[begin + 1]);
    }
    return free;
}

/// Whether two surfaces that run through an edge the same way lie over each other, instead of facing opposite ways.
bool lie_over_each_other(const Scene& scene, const Side& a, const Side& b) {
    constexpr double parallel = 1 - 1e-9;
    return scene.surfaces[a.surface].normal.dot(scene.surfaces[b.surface].normal) > parallel;
}

/// Whether two surfaces of one plane that face opposite ways touch along free edges of different lengths.
/// @param slack  how far off each other they may be
bool touch_beside_each_other(const Scene& scene, std::uint32_t a, std::uint32_t b, const Edges& free, double slack) {
    const ConvexPolygon first = outline(scene.surfaces[a]);
    const ConvexPolygon second = outline(scene.surfaces[b]);
    for (std::uint32_t i = 0; i < first.size(); ++i) {
        if (!free.contains({a, i})) continue;
        const Vector3d edge = next_corner(first, i) - first[i];
        const double length = edge.norm();
        for (std::uint32_t k = 0; k < second.size(); ++k) {
            if (!free.contains({b, k})) continue;
            const Vector3d begin = second[k] - first[i];
            const Vector3d end = next_corner(second, k) - first[i];
            // Beside each other, they run through the edge the same way.
            const double from = begin.dot(edge) / length;
            const double to = end.dot(edge) / length;
            if (std::min(to, length) - std::max(from, 0.0) <= 10 * slack) continue;
            if (begin.cross(edge).norm() <= slack * length && end.cross(edge).norm() <= slack * length) return true;
        }
    }
    return false;
}

/// Calls use(first, second) for surfaces of one face, in one plane, that face opposite ways and touch there.
template <class Use>
void for_each_opposite_neighbour(const Scene& scene, const Edges& free, const Use& use) {
    constexpr std::size_t most_compared = 1000;  // surfaces of a face: all pairs are looked at
    constexpr double rounding = 1e-6;
    const double slack = rounding * farthest_coordinate(scene);
    std::vector<std::vector<std::uint32_t>> of_face(scene.faces.size());
    for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
        const Surface& surface = scene.surfaces[s];
        if (surface.face >= 0 && is_flat(surface.shape) && !outline(surface).empty())
            of_face[static_cast<std::size_t>(surface.face)].push_back(s);
    }
    for (const std::vector<std::uint32_t>& surfaces : of_face) {
        if (surfaces.size() > most_compared) continue;
        for (std::size_t i = 0; i < surfaces.size(); ++i) {
            const Vector3d& normal = scene.surfaces[surfaces[i]].normal;
            for (std::size_t k = i + 1; k < surfaces.size(); ++k) {
                if (normal.dot(scene.surfaces[surfaces[k]].normal) < rounding - 1 &&
                    touch_beside_each_other(scene, surfaces[i], surfaces[k], free, slack))
                    use(surfaces[i], surfaces[k]);
            }
        }
    }
}

/// Surfaces that are joined, each with whether it faces the other way than the first.
struct Part {
    std::vector<std::pair<std::uint32_t, bool>> surfaces;
    bool is_one_sided = false;  ///< like Möbius's strip
};

std::vector<Part> parts_of(std::size_t surfaces,
                           const std::vector<std::vector<std::pair<std::uint32_t, bool>>>& joined) {
    constexpr char unseen = 2;
    std::vector<char> side(surfaces, unseen);
    std::vector<Part> parts;
    for (std::uint32_t first = 0; first < surfaces; ++first) {
        if (side[first] != unseen || joined[first].empty()) continue;
        Part part;
        side[first] = 0;
        part.surfaces.emplace_back(first, false);
        for (std::size_t next = 0; next < part.surfaces.size(); ++next) {
            const auto [surface, turned] = part.surfaces[next];
            for (const auto& [other, same_way] : joined[surface]) {
                const char wanted = turned != same_way ? 1 : 0;
                if (side[other] == unseen) {
                    side[other] = wanted;
                    part.surfaces.emplace_back(other, wanted == 1);
                } else {
                    part.is_one_sided = part.is_one_sided || side[other] != wanted;
                }
            }
        }
        parts.push_back(std::move(part));
    }
    return parts;
}

/// The area of other faces that a surface faces and that face it. @param sign  -1 where it is turned round
double area_seen(const Scene& scene, std::uint32_t index, double sign) {
    const Surface& surface = scene.surfaces[index];
    const auto middle_of = [](const Surface& any) {
        const Extent x = extent(any, Vector3d::UnitX()), y = extent(any, Vector3d::UnitY()),
                     z = extent(any, Vector3d::UnitZ());
        return Vector3d((x.low + x.high) / 2, (y.low + y.high) / 2, (z.low + z.high) / 2);
    };
    double sum = 0;
    for (const Surface& other : scene.surfaces) {
        if (other.face < 0 || other.face == surface.face || !is_flat(other.shape)) continue;
        const Vector3d between = middle_of(other) - middle_of(surface);
        if (sign * surface.normal.dot(between) > 0 && other.normal.dot(between) < 0) sum += area(other.shape);
    }
    return sum;
}

}  // namespace

Winding find_winding(const Scene& scene) {
    std::vector<Side> sides = sides_of(scene);
    std::vector<std::vector<std::pair<std::uint32_t, bool>>> joined(scene.surfaces.size());
    bool any = false;
    const auto join = [&](std::uint32_t a, std::uint32_t b, bool same_way) {
        any = any || same_way;
        joined[a].emplace_back(b, same_way);
        joined[b].emplace_back(a, same_way);
    };
    const Edges free = for_each_common_edge(sides, [&](const Side& a, const Side& b) {
        if (a.face != b.face) return;
        const bool same_way = a.forwards == b.forwards;
        if (same_way && lie_over_each_other(scene, a, b)) return;
        join(a.surface, b.surface, same_way);
    });
    for_each_opposite_neighbour(scene, free, [&](std::uint32_t a, std::uint32_t b) { join(a, b, true); });
    Winding winding;
    if (!any) return winding;
    for (const Part& part : parts_of(scene.surfaces.size(), joined)) {
        std::array<double, 2> areas{};
        for (const auto& [surface, turned] : part.surfaces)
            areas[turned ? 1 : 0] += area(scene.surfaces[surface].shape);
        if (areas[1] == 0) continue;
        constexpr double rounding = 1e-9;
        bool turn_others = areas[1] < areas[0];
        bool is_decided = std::abs(areas[0] - areas[1]) > rounding * areas[0];
        if (!is_decided) {
            std::array<double, 2> seen{};  // area seen with the others turned; with all but them turned
            for (const auto& [surface, turned] : part.surfaces) {
                seen[0] += area_seen(scene, surface, turned ? -1 : 1);
                seen[1] += area_seen(scene, surface, turned ? 1 : -1);
            }
            turn_others = seen[0] > seen[1];
            is_decided = seen[0] != seen[1];
        }
        if (part.is_one_sided || !is_decided) {
            winding.undecided.push_back(scene.surfaces[part.surfaces.front().first].face);
            continue;
        }
        for (const auto& [surface, turned] : part.surfaces) {
            if (turned == turn_others) winding.turned.push_back(surface);
        }
    }
    std::sort(winding.turned.begin(), winding.turned.end());
    return winding;
}

std::vector<std::pair<int, int>> faces_wound_differently(const Scene& scene) {
    std::vector<Side> sides = sides_of(scene);
    std::vector<std::pair<int, int>> pairs;
    for_each_common_edge(sides, [&](const Side& a, const Side& b) {
        if (a.face != b.face && a.forwards == b.forwards && !lie_over_each_other(scene, a, b))
            pairs.push_back(std::minmax(a.face, b.face));
    });
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

}  // namespace ff::studies
