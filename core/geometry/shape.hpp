#pragma once

#include <Eigen/Core>

#include <variant>

namespace ff {

/// Shapes of surfaces. Each is the image of the unit square under a map that preserves ratios of area
/// (core/geometry/surface_map.hpp); each shape states what s and t mean. Lengths in the scene's unit.

/// The points corner + s * edge_u + t * edge_v with 0 <= s, t <= 1.
struct Parallelogram {
    Eigen::Vector3d corner;
    Eigen::Vector3d edge_u;
    Eigen::Vector3d edge_v;

    bool operator==(const Parallelogram&) const = default;
};

/// Corners a, b, c: s is the square of the distance from a, as a share of that of the opposite side; t leads from b's
/// side to c's.
struct Triangle {
    Eigen::Vector3d a, b, c;

    bool operator==(const Triangle&) const = default;
};

/// A disc, or an annulus where inner_radius > 0, in the plane through `centre` that the surface's normal is
/// perpendicular to: s leads from the inner to the outer rim, t is the azimuth in turns.
struct Disc {
    Eigen::Vector3d centre;
    double inner_radius = 0;
    double outer_radius = 0;

    bool operator==(const Disc&) const = default;
};

/// Which side of a curved shape radiates.
enum class Facing {
    outward,  ///< away from the axis
    inward,
};

/// The wall of a cone frustum from `base` to base + axis; of a cylinder where both radii are equal, of a whole cone
/// where one is 0. s leads along the wall, t is the azimuth in turns.
struct Frustum {
    Eigen::Vector3d base;
    Eigen::Vector3d axis;  ///< from the centre of the base to the centre of the top
    double base_radius = 0;
    double top_radius = 0;
    Facing facing = Facing::outward;

    bool operator==(const Frustum&) const = default;
};

/// The part of a sphere between the planes at low * radius and high * radius along the axis, -1 <= low < high <= 1: a
/// cap where high is 1, the whole sphere from -1 to 1. s leads from low to high, t is the azimuth in turns.
struct SphereZone {
    Eigen::Vector3d centre;
    Eigen::Vector3d axis;  ///< unit length
    double radius = 0;
    double low = -1;
    double high = 1;
    Facing facing = Facing::outward;

    bool operator==(const SphereZone&) const = default;
};

using Shape = std::variant<Parallelogram, Triangle, Disc, Frustum, SphereZone>;

/// Parallelograms, triangles and discs.
inline bool is_flat(const Shape& shape) {
    return !std::holds_alternative<Frustum>(shape) && !std::holds_alternative<SphereZone>(shape);
}

/// Parallelograms and triangles.
inline bool is_polygon(const Shape& shape) {
    return std::holds_alternative<Parallelogram>(shape) || std::holds_alternative<Triangle>(shape);
}

/// The side of a curved shape that radiates. @pre the shape is not flat
inline Facing facing(const Shape& shape) {
    if (const auto* wall = std::get_if<Frustum>(&shape)) return wall->facing;
    return std::get<SphereZone>(shape).facing;
}

}  // namespace ff
