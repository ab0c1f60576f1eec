#include "studies/scene_files/meetings.hpp"

#include "core/geometry/box_tree.hpp"
#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/place_numbers.hpp"
#include "core/geometry/placement.hpp"
#include "core/geometry/scene.hpp"
#include "core/geometry/surface_map.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

namespace ff::studies {
namespace {

using Eigen::Vector3d;

/// A surface that an edge belongs to.
struct Side {
    std::uint32_t low = 0, high = 0;  ///< numbers of the edge's ends
    int face = 0;
    std::uint32_t surface = 0;
    bool forwards = false;  ///< it runs through the edge from `low` to `high`, counter-clockwise around its normal
    Vector3d from, to;      ///< ends of the edge, in the order in which the surface runs through it
};

std::vector<Side> sides_of(const Scene& scene) {
    PlaceNumbers number(resolution_of_places *
                        std::max(farthest_coordinate(scene), std::numeric_limits<double>::min()));
    std::vector<Side> sides;
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
        const Surface& surface = scene.surfaces[s];
        if (surface.face < 0) continue;
        const ConvexPolygon corners = outline(surface);
        numbers.clear();
        for (const Vector3d& corner : corners) numbers.push_back(number(corner));
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            const auto [low, high] = std::minmax(numbers[k], next_corner(numbers, k));
            sides.push_back({low, high, surface.face, s, numbers[k] == low, corners[k], next_corner(corners, k)});
        }
    }
    return sides;
}

/// How far apart edges or circles of this length may be that are meant to be one.
double slack_of(const Scene& scene, double length) {
    constexpr double rounded = 1e-4;
    constexpr double largest = 0.01;
    const double digits = std::max(4 * scene.coordinate_rounding, scene.coordinate_step);
    return std::min(std::max(rounded * length, digits), largest * length);
}

/// Whether surfaces that run through an edge the same way lie over each other, instead of facing opposite ways.
bool lie_over_each_other(const Scene& scene, const Side& a, const Side& b) {
    constexpr double parallel = 1 - 1e-6;
    return scene.surfaces[a.surface].normal.dot(scene.surfaces[b.surface].normal) > parallel;
}

/// Pairs of surfaces that meet in edges, where nothing else does: where bodies, fins or floors meet, an edge says
/// nothing of which of them face the same way.
class CommonEdges {
  public:
    explicit CommonEdges(const Scene& scene) : scene_(scene) {}

    /// Calls use(Meeting).
    template <class Use>
    void for_each(const Use& use) const {
        std::vector<Side> sides = sides_of(scene_);
        const auto key = [](const Side& side) { return std::pair(side.low, side.high); };
        std::sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) {
            return std::pair(key(a), a.surface) < std::pair(key(b), b.surface);
        });
        std::vector<Side> free;
        for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
            while (end < sides.size() && key(sides[end]) == key(sides[begin])) ++end;
            if (end - begin == 1) free.push_back(sides[begin]);
            if (end - begin != 2) continue;
            const Side& a = sides[begin];
            const Side& b = sides[begin + 1];
            if (a.forwards != b.forwards)
                use(Meeting{a.surface, b.surface, false});
            else if (!lie_over_each_other(scene_, a, b) && is_theirs_alone(a, b, a.from, a.to))
                use(Meeting{a.surface, b.surface, true});
        }
        for_each_that_nearly_meet(free, use);
    }

  private:
    const Scene& scene_;
    mutable std::optional<BoxTree> surfaces_;  ///< made when it is first needed

    /// Whether no third surface reaches all along a part of an edge.
    [[nodiscard]] bool is_theirs_alone(const Side& a, const Side& b, const Vector3d& from, const Vector3d& to) const {
        if (!surfaces_) {
            std::vector<Eigen::AlignedBox3d> boxes;
            for (const Surface& surface : scene_.surfaces) boxes.push_back(box_around(surface));
            surfaces_.emplace(std::move(boxes));
        }
        const double slack = slack_of(scene_, (to - from).norm());
        const auto is_touched = [&](double share) {
            const Vector3d place = from + share * (to - from);
            bool touched = false;
            surfaces_->within(Eigen::AlignedBox3d(place, place), slack, [&](std::uint32_t other) {
                const Surface& third = scene_.surfaces[other];
                if (touched || other == a.surface || other == b.surface || !is_polygon(third.shape)) return;
                touched = distance(place, outline(third), third.normal) <= slack;
            });
            return touched;
        };
        return !(is_touched(0.25) && is_touched(0.5) && is_touched(0.75));
    }

    /// Edges of different lengths, as in T-junctions, or with ends that rounding has moved apart.
    template <class Use>
    void for_each_that_nearly_meet(const std::vector<Side>& free, const Use& use) const {
        std::vector<Eigen::AlignedBox3d> boxes;
        for (const Side& side : free) boxes.push_back(Eigen::AlignedBox3d(side.from).extend(side.to));
        const BoxTree edges(boxes);
        for (std::size_t i = 0; i < free.size(); ++i) {
            const Side& a = free[i];
            const Vector3d edge = a.to - a.from;
            const double length = edge.norm();
            edges.within(boxes[i], slack_of(scene_, length), [&](std::uint32_t k) {
                const Side& b = free[k];
                if (k <= i || b.surface == a.surface) return;
                const double slack = slack_of(scene_, std::min(length, (b.to - b.from).norm()));
                const auto distance_of = [&](const Vector3d& end) {
                    return (end - a.from).cross(edge).norm() / length;
                };
                if (std::max(distance_of(b.from), distance_of(b.to)) > slack) return;
                const double from = (b.from - a.from).dot(edge) / length;
                const double to = (b.to - a.from).dot(edge) / length;
                const double begin = std::max(std::min(from, to), 0.0);
                const double end = std::min(std::max(from, to), length);
                if (end - begin <= 10 * slack || (from < to && lie_over_each_other(scene_, a, b))) return;
                if (is_theirs_alone(a, b, a.from + begin / length * edge, a.from + end / length * edge))
                    use(Meeting{a.surface, b.surface, from < to});
            });
        }
    }
};

/// A circle that bounds a round surface.
struct Rim {
    std::uint32_t surface = 0;
    Vector3d centre;
    double radius = 0;
    Vector3d axis;  ///< unit length; the surface runs through the circle counter-clockwise around it
};

std::vector<Rim> rims_of(const Scene& scene) {
    std::vector<Rim> rims;
    for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
        const Surface& surface = scene.surfaces[s];
        if (surface.face < 0) continue;
        const double side = !is_flat(surface.shape) && facing(surface.shape) == Facing::inward ? -1 : 1;
        const auto add = [&](const Vector3d& centre, double radius, const Vector3d& axis) {
            if (radius > 0) rims.push_back({s, centre, radius, side * axis.normalized()});
        };
        if (const auto* disc = std::get_if<Disc>(&surface.shape)) {
            add(disc->centre, disc->outer_radius, surface.normal);
            add(disc->centre, disc->inner_radius, -surface.normal);
        } else if (const auto* wall = std::get_if<Frustum>(&surface.shape)) {
            add(wall->base, wall->base_radius, wall->axis);
            add(wall->base + wall->axis, wall->top_radius, -wall->axis);
        } else if (const auto* zone = std::get_if<SphereZone>(&surface.shape)) {
            for (const double height : {zone->low, zone->high}) {
                add(zone->centre + height * zone->radius * zone->axis,
                    zone->radius * std::sqrt(std::max(0.0, 1 - height * height)),
                    height == zone->low ? zone->axis : Vector3d(-zone->axis));
            }
        }
    }
    return rims;
}

/// Calls use(Meeting) for surfaces that have a circle in common, which no third one has.
template <class Use>
void for_each_common_rim(const Scene& scene, const Use& use) {
    const std::vector<Rim> rims = rims_of(scene);
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const Rim& rim : rims) boxes.emplace_back(rim.centre, rim.centre);
    const BoxTree centres(boxes);
    std::vector<std::uint32_t> same;
    for (std::uint32_t i = 0; i < rims.size(); ++i) {
        const Rim& rim = rims[i];
        const double slack = slack_of(scene, rim.radius);
        same.clear();
        centres.within(boxes[i], slack, [&](std::uint32_t k) {
            const bool is_same = std::abs(rims[k].radius - rim.radius) <= slack &&
                                 rims[k].axis.cross(rim.axis).norm() * rim.radius <= slack;
            if (k != i && is_same) same.push_back(k);
        });
        if (same.size() != 1 || same.front() < i) continue;
        const Rim& other = rims[same.front()];
        const bool same_way = rim.axis.dot(other.axis) > 0;
        const bool over_each_other =
            is_flat(scene.surfaces[rim.surface].shape) && is_flat(scene.surfaces[other.surface].shape);
        if (rim.surface != other.surface && !(same_way && over_each_other))
            use(Meeting{rim.surface, other.surface, same_way});
    }
}

}  // namespace

std::vector<Meeting> find_meetings(const Scene& scene) {
    std::vector<Meeting> meetings;
    const auto keep = [&](const Meeting& meeting) { meetings.push_back(meeting); };
    CommonEdges(scene).for_each(keep);
    for_each_common_rim(scene, keep);
    return meetings;
}

}  // namespace ff::studies
