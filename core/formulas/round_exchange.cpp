#include "core/formulas/round_exchange.hpp"

#include "core/geometry/scene.hpp"
#include "core/geometry/surface_map.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;

constexpr double last_place = std::numeric_limits<double>::epsilon();
/// Surfaces that reach less far behind each other, in units of the extent of the pair, are in front.
constexpr double rounding_of_heights = 1e-12;

/// The circle centre + cos(theta) u + sin(theta) v, which a rim follows in this direction (sign 1) or against it (-1).
struct Circle {
    Vector3d centre;
    Vector3d u;
    Vector3d v;
    double radius = 0;
    double sign = 1;

    [[nodiscard]] Vector3d at(double theta) const { return centre + std::cos(theta) * u + std::sin(theta) * v; }
    [[nodiscard]] Vector3d along(double theta) const { return sign * (std::cos(theta) * v - std::sin(theta) * u); }
};

/// A flat surface and its rim, which is either straight or round.
struct Flat {
    Vector3d normal;
    Vector3d place;  ///< in its plane
    std::vector<DirectedEdge<double>> edges;
    std::vector<Circle> circles;
};

/// Coordinates relative to an origin, in a unit of which the pair extends over one or two.
struct Frame {
    Vector3d origin;
    double unit = 1;

    Frame(const Surface& from, const Surface& to) {
        Eigen::AlignedBox3d box = box_around(from);
        box.extend(box_around(to));
        origin = box.center();
        unit = box.diagonal().norm() / 2;
    }
    [[nodiscard]] Vector3d moved(const Vector3d& place) const { return (place - origin) / unit; }
};
/// Distances in a frame are at most this.
constexpr double farthest = 2;

Flat flat(const Surface& surface, const Frame& frame) {
    Flat result{surface.normal, {}, {}, {}};
    if (const auto* disc = std::get_if<Disc>(&surface.shape)) {
        result.place = frame.moved(disc->centre);
        const Vector3d x = perpendicular(surface.normal);
        const Vector3d y = surface.normal.cross(x);
        const auto add = [&](double radius, double sign) {
            result.circles.push_back({result.place, radius * x, radius * y, radius, sign});
        };
        add(disc->outer_radius / frame.unit, 1);
        if (disc->inner_radius > 0) add(disc->inner_radius / frame.unit, -1);
        return result;
    }
    const std::vector<Vector3d> around = corners_of<double>(surface);
    result.place = frame.moved(around.front());
    for (std::size_t k = 0; k < around.size(); ++k)
        result.edges.push_back({frame.moved(around[k]), frame.moved(around[(k + 1) % around.size()])});
    return result;
}

/// The least height of a surface above the plane of another one.
double least_height(const Flat& surface, const Flat& plane) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& edge : surface.edges) least = std::min(least, plane.normal.dot(edge.begin - plane.place));
    for (const Circle& circle : surface.circles) {
        const double swing = std::hypot(plane.normal.dot(circle.u), plane.normal.dot(circle.v));
        least = std::min(least, plane.normal.dot(circle.centre - plane.place) - swing);
    }
    return least;
}

double distance_to(const Vector3d& place, const DirectedEdge<double>& edge) {
    const Vector3d along = edge.end - edge.begin;
    const double share = std::clamp((place - edge.begin).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (place - edge.begin - share * along).norm();
}

double distance_to(const Vector3d& place, const Circle& circle) {
    const Vector3d way = place - circle.centre;
    const Vector3d axis = circle.u.cross(circle.v).normalized();
    const double height = axis.dot(way);
    return std::hypot(height, (way - height * axis).norm() - circle.radius);
}

/// Lower bound of the distance of a circle from the rim of another surface.
double distance_of_rims(const Circle& circle, const Flat& other) {
    constexpr int places = 256;
    double least = farthest;
    for (int k = 0; k < places; ++k) {
        const Vector3d place = circle.at(2 * std::numbers::pi * k / places);
        for (const auto& edge : other.edges) least = std::min(least, distance_to(place, edge));
        for (const Circle& across : other.circles) least = std::min(least, distance_to(place, across));
    }
    return least - std::numbers::pi / places * circle.radius;
}

/// The trapezoidal rule for a periodic function that is analytic, and at most `size`, in a strip around the real line.
struct PeriodicRule {
    std::size_t nodes = 0;
    double error = 0;  ///< bound, for the mean over a period

    PeriodicRule(double strip, double size, double wanted)
        : nodes(static_cast<std::size_t>(std::ceil(std::min(1e9, std::log1p(2 * size / wanted) / strip)))),
          error(2 * size / std::expm1(strip * static_cast<double>(nodes))) {}
};
constexpr std::size_t most_nodes = 1u << 13;
/// Nodes of one rule times nodes of the other.
constexpr std::size_t most_pairs_of_nodes = 1u << 22;

double angle(std::size_t node, const PeriodicRule& rule) {
    return 2 * std::numbers::pi * static_cast<double>(node) / static_cast<double>(rule.nodes);
}

/// Half of the strip in which integrands along a circle are analytic, at least at this distance from it: there they
/// stay finite.
double half_strip(const Circle& circle, double distance) {
    return std::log1p(distance / (2 * circle.radius));
}

double length(const Flat& surface) {
    double sum = 0;
    for (const auto& edge : surface.edges) sum += (edge.end - edge.begin).norm();
    for (const Circle& circle : surface.circles) sum += 2 * std::numbers::pi * circle.radius;
    return sum;
}

/// A sum, and that of the sizes of its terms, by which rounding grows.
struct RimIntegral {
    Vector3d value = Vector3d::Zero();
    double size = 0;

    void add(const Vector3d& term) {
        value += term;
        size += term.norm();
    }
};

/// The integral of ln r times the direction of a rim, where r is the distance from a place.
RimIntegral integral_from(const Vector3d& place, const Flat& other, const std::vector<PeriodicRule>& rules) {
    RimIntegral result;
    for (const auto& edge : other.edges)
        result.add((edge.end - edge.begin).normalized() * log_distance_integral(place, edge));
    for (std::size_t c = 0; c < other.circles.size(); ++c) {
        RimIntegral sum;
        for (std::size_t k = 0; k < rules[c].nodes; ++k) {
            const double theta = angle(k, rules[c]);
            sum.add(std::log((other.circles[c].at(theta) - place).squaredNorm()) / 2 * other.circles[c].along(theta));
        }
        const double weight = 2 * std::numbers::pi / static_cast<double>(rules[c].nodes);
        result.value += weight * sum.value;
        result.size += weight * sum.size;
    }
    return result;
}

/// Exchange area of a disc and a flat surface in a frame.
std::optional<BoundedValue<double>> disc_exchange(const Flat& disc, const Flat& other, double wanted) {
    if (std::min(least_height(disc, other), least_height(other, disc)) < -rounding_of_heights) return std::nullopt;
    BoundedValue<double> result;
    for (const Circle& circle : disc.circles) {
        const double distance = distance_of_rims(circle, other);
        if (!(distance > 0)) return std::nullopt;
        // In half of the strip places move by at most half the distance, so that |r^2| lies between distance^2 / 4 and
        // (farthest + distance / 2)^2, with a positive real part. A constant added to the logarithm changes nothing.
        const double logarithm = (std::log(2 * farthest / distance + 1) + std::numbers::pi / 2) / 2;
        const auto rule_on = [&](const Circle& along, double opposite) {
            const double size = along.radius * (1 + distance / (2 * along.radius)) * opposite * logarithm;
            return PeriodicRule(half_strip(along, distance), size, wanted / 8);
        };
        const PeriodicRule rule = rule_on(circle, length(other));
        std::vector<PeriodicRule> rules;
        for (const Circle& across : other.circles) {
            rules.push_back(rule_on(across, 2 * std::numbers::pi * circle.radius));
            result.error += rules.back().error;
            if (std::max(rule.nodes, rules.back().nodes) > most_nodes) return std::nullopt;
            if (rule.nodes * rules.back().nodes > most_pairs_of_nodes) return std::nullopt;
        }
        if (rule.nodes > most_nodes) return std::nullopt;
        double sum = 0;
        double sizes = 0;
        for (std::size_t k = 0; k < rule.nodes; ++k) {
            const double theta = angle(k, rule);
            const RimIntegral inner = integral_from(circle.at(theta), other, rules);
            sum += circle.along(theta).dot(inner.value);
            sizes += circle.radius * inner.size;
        }
        // 1 / (2 pi) times the integral over the angle is the mean.
        result.value += sum / static_cast<double>(rule.nodes);
        result.error += rule.error + 16 * last_place * sizes / static_cast<double>(rule.nodes);
    }
    result.value = std::max(0.0, result.value);
    return result;
}

/// Solid angle of a triangle whose corners are given relative to the eye. @see [vanoosterom1983]
double solid_angle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const double across =
        a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() + b.dot(c) * a.norm() + c.dot(a) * b.norm();
    return 2 * std::atan2(std::abs(a.dot(b.cross(c))), across);
}

/// Solid angle of what a circle encloses. @param height  of the eye above its plane
std::optional<BoundedValue<double>> solid_angle(const Circle& circle, const Vector3d& eye, double height,
                                                double wanted) {
    const double nearest = distance_to(eye, circle);
    const Vector3d axis = circle.u.cross(circle.v).normalized();
    const Vector3d foot = eye - axis.dot(eye - circle.centre) * axis;
    // In half of the strip |r| >= nearest / 2 and, since r^2 has a positive real part, |r + height| >= that / sqrt(2).
    const double most =
        (farthest + nearest / 2) * (circle.radius + nearest / 2) * 4 * std::numbers::sqrt2 / (nearest * nearest);
    const PeriodicRule rule(half_strip(circle, nearest), most, wanted / (2 * std::numbers::pi));
    if (rule.nodes > most_nodes) return std::nullopt;
    double sum = 0;
    double sizes = 0;
    for (std::size_t k = 0; k < rule.nodes; ++k) {
        const double theta = angle(k, rule);
        const Vector3d way = circle.at(theta) - foot;
        const double r = std::hypot(way.norm(), height);
        const double term = axis.dot(way.cross(circle.sign * circle.along(theta))) / (r * (r + height));
        sum += term;
        sizes += std::abs(term);
    }
    const double weight = 2 * std::numbers::pi / static_cast<double>(rule.nodes);
    return BoundedValue<double>{weight * sum, 2 * std::numbers::pi * rule.error + 16 * last_place * weight * sizes};
}

/// Exchange area of a sphere and a flat surface in a frame.
std::optional<BoundedValue<double>> sphere_exchange(const Vector3d& centre, double radius, const Flat& other,
                                                    double wanted) {
    const double height = other.normal.dot(centre - other.place);
    if (height - radius < -rounding_of_heights) return std::nullopt;
    BoundedValue<double> angle;
    for (std::size_t k = 1; k + 1 < other.edges.size(); ++k) {
        angle.value +=
            solid_angle(other.edges[0].begin - centre, other.edges[k].begin - centre, other.edges[k].end - centre);
    }
    angle.error = 32 * last_place * angle.value + 4 * last_place;
    for (const Circle& circle : other.circles) {
        const auto enclosed = solid_angle(circle, centre, height, wanted / (4 * radius * radius));
        if (!enclosed) return std::nullopt;
        angle.value += circle.sign * enclosed->value;
        angle.error += enclosed->error;
    }
    return BoundedValue<double>{radius * radius * std::max(0.0, angle.value), radius * radius * angle.error};
}

const SphereZone* whole_sphere(const Surface& surface) {
    const auto* zone = std::get_if<SphereZone>(&surface.shape);
    const bool is_whole = zone != nullptr && zone->low == -1 && zone->high == 1 && zone->facing == Facing::outward;
    return is_whole ? zone : nullptr;
}

}  // namespace

std::optional<BoundedValue<double>> round_exchange_area(const Surface& from, const Surface& to, double wanted) {
    if (!is_flat(to.shape)) return is_flat(from.shape) ? round_exchange_area(to, from, wanted) : std::nullopt;
    const Frame frame(from, to);
    const double square = frame.unit * frame.unit;
    std::optional<BoundedValue<double>> found;
    if (const SphereZone* sphere = whole_sphere(from)) {
        found =
            sphere_exchange(frame.moved(sphere->centre), sphere->radius / frame.unit, flat(to, frame), wanted / square);
    } else if (std::holds_alternative<Disc>(from.shape)) {
        found = disc_exchange(flat(from, frame), flat(to, frame), wanted / square);
    } else if (std::holds_alternative<Disc>(to.shape) && is_flat(from.shape)) {
        found = disc_exchange(flat(to, frame), flat(from, frame), wanted / square);
    }
    if (!found) return std::nullopt;
    return BoundedValue<double>{square * found->value, square * found->error + last_place * square * found->value};
}

}  // namespace ff
