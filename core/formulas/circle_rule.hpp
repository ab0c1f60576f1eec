#pragma once

#include "core/formulas/polygon_exchange.hpp"
#include "core/geometry/surface_map.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

/// Integrals along circles by the trapezoidal rule, whose error for analytic periodic functions has a bound
/// [trefethen2014]. Of functions of the distance to a place the complex continuation is known: they are analytic where
/// the imaginary part of the angle is below ln(1 + d / R), d being the distance of the place from a circle of radius R.
namespace ff::circles {

/// Coordinates relative to an origin, in a unit in which no two places of a pair are more than 2 apart.
struct Frame {
    static constexpr double farthest = 2;
    /// What reaches less far behind something lies in front of it.
    static constexpr double rounding = 1e-12;

    Eigen::Vector3d origin;
    double unit = 1;

    Frame(const Surface& from, const Surface& to) {
        Eigen::AlignedBox3d box = box_around(from);
        box.extend(box_around(to));
        origin = box.center();
        unit = box.diagonal().norm() / farthest;
    }
    [[nodiscard]] Eigen::Vector3d moved(const Eigen::Vector3d& place) const { return (place - origin) / unit; }
    [[nodiscard]] double reduced(double area) const { return area / (unit * unit); }
    [[nodiscard]] std::optional<BoundedValue<double>> restored(std::optional<BoundedValue<double>> area) const {
        if (!area) return std::nullopt;
        const double square = unit * unit;
        return BoundedValue<double>{square * std::max(0.0, area->value), square * area->error};
    }
};

/// The circle centre + cos(theta) u + sin(theta) v of a rim, which counts with this sign.
struct Circle {
    Eigen::Vector3d centre;
    Eigen::Vector3d u;
    Eigen::Vector3d v;
    double radius = 0;
    double sign = 1;

    /// @param axis  of unit length; angles grow in its sense
    Circle(Eigen::Vector3d middle, const Eigen::Vector3d& axis, double size, double sense)
        : centre(std::move(middle)), u(size * perpendicular(axis)), v(axis.cross(u)), radius(size), sign(sense) {}

    [[nodiscard]] Eigen::Vector3d at(double theta) const { return centre + std::cos(theta) * u + std::sin(theta) * v; }
    /// The derivative of that.
    [[nodiscard]] Eigen::Vector3d along(double theta) const { return std::cos(theta) * v - std::sin(theta) * u; }

    [[nodiscard]] double distance_to(const Eigen::Vector3d& place) const {
        const Eigen::Vector3d way = place - centre;
        const Eigen::Vector3d axis = u.cross(v).normalized();
        const double height = axis.dot(way);
        return std::hypot(height, (way - height * axis).norm() - radius);
    }

    /// Half of the strip in which integrands are analytic that depend on the distance to places so far from the
    /// circle. There the circle's places move by at most half that distance.
    [[nodiscard]] double half_strip(double distance) const { return std::log1p(distance / (2 * radius)); }
};

/// The rule for a function that is analytic, and at most `size`, in a strip around the real line.
struct PeriodicRule {
    static constexpr std::size_t most_nodes = 1u << 13;

    std::size_t nodes = 0;
    double error = 0;  ///< bound, for the mean over a period

    PeriodicRule(double strip, double size, double wanted)
        : nodes(static_cast<std::size_t>(std::ceil(std::min(1e9, std::log1p(2 * size / wanted) / strip)))),
          error(2 * size / std::expm1(strip * static_cast<double>(nodes))) {}

    [[nodiscard]] bool has_too_many_nodes() const { return nodes > most_nodes; }
    [[nodiscard]] double angle(std::size_t node) const {
        return 2 * std::numbers::pi * static_cast<double>(node) / static_cast<double>(nodes);
    }
};

}  // namespace ff::circles
