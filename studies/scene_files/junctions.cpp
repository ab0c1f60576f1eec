#include "studies/scene_files/junctions.hpp"

#include "core/geometry/box_tree.hpp"
#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/place_numbers.hpp"
#include "core/geometry/placement.hpp"
#include "core/geometry/round_ends.hpp"
#include "core/geometry/scene.hpp"
#include "core/geometry/surface_map.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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
            sides.push_back({low, high, s, numbers[k] == low, corners[k], next_corner(corners, k)});
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

/// The same for the edge of a surface: far less than the surface is wide there, so that no two of its edges are one.
double slack_of(const Scene& scene, const Side& side) {
    constexpr double narrow = 0.1;
    const double length = (side.to - side.from).norm();
    return std::min(slack_of(scene, length), narrow * area(scene.surfaces[side.surface].shape) / length);
}

/// Finds surfaces that meet where no third one does: where bodies, fins or floors meet, an edge says nothing of which
/// of them face the same way.
class JunctionFinder {
  public:
    explicit JunctionFinder(const Scene& scene) : scene_(scene) {}

    std::vector<Junction> find() && {
        find_common_edges();
        find_common_rims();
        return std::move(junctions_);
    }

  private:
    const Scene& scene_;
    std::optional<BoxTree> surfaces_;  ///< made when it is first needed
    std::vector<Junction> junctions_;

    [[nodiscard]] double cosine(std::uint32_t a, std::uint32_t b) const {
        return scene_.surfaces[a].normal.dot(scene_.surfaces[b].normal);
    }

    /// Whether surfaces that run through an edge the same way lie over each other, instead of facing opposite ways.
    [[nodiscard]] bool lie_over_each_other(std::uint32_t a, std::uint32_t b) const {
        constexpr double parallel = 1 - 1e-6;
        return cosine(a, b) > parallel;
    }

    void add(std::uint32_t a, std::uint32_t b, bool same_way, bool certain = true) {
        junctions_.push_back({a, b, same_way, certain});
    }

    /// Whether no third surface reaches all of these places.
    bool is_theirs_alone(std::uint32_t a, std::uint32_t b, const std::array<Vector3d, 3>& places, double slack) {
        if (!surfaces_) {
            std::vector<Eigen::AlignedBox3d> boxes;
            for (const Surface& surface : scene_.surfaces) boxes.push_back(box_around(surface));
            surfaces_.emplace(std::move(boxes));
        }
        return !std::all_of(places.begin(), places.end(), [&](const Vector3d& place) {
            bool touched = false;
            surfaces_->within(Eigen::AlignedBox3d(place, place), slack, [&](std::uint32_t other) {
                touched = touched || (other != a && other != b && is_on(scene_.surfaces[other], place, slack));
            });
            return touched;
        });
    }

    static bool is_on(const Surface& surface, const Vector3d& place, double slack) {
        if (is_polygon(surface.shape)) return distance(place, outline(surface), surface.normal) <= slack;
        const auto* disc = std::get_if<Disc>(&surface.shape);
        if (disc == nullptr || std::abs(surface.normal.dot(place - disc->centre)) > slack) return false;
        const double radius = (place - disc->centre).norm();
        return radius >= disc->inner_radius - slack && radius <= disc->outer_radius + slack;
    }

    static std::array<Vector3d, 3> places_between(const Vector3d& from, const Vector3d& to) {
        return {(3 * from + to) / 4, (from + to) / 2, (from + 3 * to) / 4};
    }

    void find_common_edges() {
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
            const double slack = std::min(slack_of(scene_, a), slack_of(scene_, b));
            if (a.forwards != b.forwards)
                add(a.surface, b.surface, false);
            else if (!lie_over_each_other(a.surface, b.surface) &&
                     is_theirs_alone(a.surface, b.surface, places_between(a.from, a.to), slack))
                add(a.surface, b.surface, true);
        }
        find_near_edges(free);
    }

    /// Edges of different lengths, as in T-junctions, or with ends that rounding has moved apart.
    void find_near_edges(const std::vector<Side>& free) {
        constexpr double level = 1 - 1e-4;
        std::vector<Eigen::AlignedBox3d> boxes;
        for (const Side& side : free) boxes.push_back(Eigen::AlignedBox3d(side.from).extend(side.to));
        const BoxTree edges(boxes);
        for (std::uint32_t i = 0; i < free.size(); ++i) {
            const Side& a = free[i];
            const Vector3d edge = a.to - a.from;
            const double length = edge.norm();
            const double slack_of_first = slack_of(scene_, a);
            edges.within(boxes[i], slack_of_first, [&](std::uint32_t k) {
                const Side& b = free[k];
                if (k <= i || b.surface == a.surface) return;
                const double slack = std::min(slack_of_first, slack_of(scene_, b));
                const auto distance_of = [&](const Vector3d& end) {
                    return (end - a.from).cross(edge).norm() / length;
                };
                if (std::max(distance_of(b.from), distance_of(b.to)) > slack) return;
                const double from = (b.from - a.from).dot(edge) / length;
                const double to = (b.to - a.from).dot(edge) / length;
                const double begin = std::max(std::min(from, to), 0.0);
                const double end = std::min(std::max(from, to), length);
                if (end - begin <= 10 * slack) return;
                const bool is_whole =
                    begin <= slack && length - end <= slack && std::abs(to - from) - length <= 2 * slack;
                const bool certain = is_whole || std::abs(cosine(a.surface, b.surface)) > level;
                if (from < to && lie_over_each_other(a.surface, b.surface)) return;
                const auto places = places_between(a.from + begin / length * edge, a.from + end / length * edge);
                if (is_theirs_alone(a.surface, b.surface, places, slack)) add(a.surface, b.surface, from < to, certain);
            });
        }
    }

    /// A circle that bounds a round surface.
    struct Rim {
        std::uint32_t surface = 0;
        Vector3d centre;
        double radius = 0;
        Vector3d axis;  ///< unit length; the surface runs through the circle counter-clockwise around it

        [[nodiscard]] std::array<Vector3d, 3> places() const {
            const Vector3d u = axis.unitOrthogonal();
            const Vector3d v = axis.cross(u);
            return {centre + radius * u, centre + radius * v, centre - radius * (u + v).normalized()};
        }
    };

    [[nodiscard]] std::vector<Rim> rims() const {
        std::vector<Rim> rims;
        for (std::uint32_t s = 0; s < scene_.surfaces.size(); ++s) {
            const Surface& surface = scene_.surfaces[s];
            if (surface.face < 0) continue;
            if (const auto* disc = std::get_if<Disc>(&surface.shape)) {
                rims.push_back({s, disc->centre, disc->outer_radius, surface.normal});
                if (disc->inner_radius > 0) rims.push_back({s, disc->centre, disc->inner_radius, -surface.normal});
            }
            for (const RoundEnd& end : round_ends(surface.shape))
                rims.push_back({s, end.centre, end.radius,
                                facing(surface.shape) == Facing::outward ? end.inwards : Vector3d(-end.inwards)});
        }
        return rims;
    }

    void find_common_rims() {
        const std::vector<Rim> all = rims();
        std::vector<Eigen::AlignedBox3d> boxes;
        for (const Rim& rim : all) boxes.emplace_back(rim.centre, rim.centre);
        const BoxTree centres(boxes);
        std::vector<std::uint32_t> same;
        for (std::uint32_t i = 0; i < all.size(); ++i) {
            const Rim& rim = all[i];
            const double slack = slack_of(scene_, rim.radius);
            same.clear();
            centres.within(boxes[i], slack, [&](std::uint32_t k) {
                const bool is_same = std::abs(all[k].radius - rim.radius) <= slack &&
                                     all[k].axis.cross(rim.axis).norm() * rim.radius <= slack;
                if (k != i && is_same) same.push_back(k);
            });
            if (same.size() != 1 || same.front() < i || all[same.front()].surface == rim.surface) continue;
            const Rim& other = all[same.front()];
            const bool same_way = rim.axis.dot(other.axis) > 0;
            if (same_way && lie_over_each_other(rim.surface, other.surface)) continue;
            if (is_theirs_alone(rim.surface, other.surface, rim.places(), slack))
                add(rim.surface, other.surface, same_way);
        }
    }
};

}  // namespace

std::vector<Junction> find_junctions(const Scene& scene) {
    return JunctionFinder(scene).find();
}

}  // namespace ff::studies
