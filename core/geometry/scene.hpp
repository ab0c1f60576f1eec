#pragma once

#include "core/geometry/subdivision.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

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

/// Belongs to no face: an obstacle. Rays that end there are not counted.
inline constexpr int no_face = -1;

/// One piece of a scene's boundary. It radiates and receives on one side only: that of `normal` (unit length) where it
/// is flat, that of its `facing` where it is curved (`normal` is then 0).
struct Surface {
    Shape shape;
    Eigen::Vector3d normal;
    int face = 0;  ///< index into Scene::faces, no_face or mirror_face (core/visibility/mirrors.hpp)
    Grid grid = undivided;
};

inline Grid Subdivision::of(const Surface& surface) const {
    return {surface.grid.columns * m, surface.grid.rows * m};
}

/// The part of a face that something stands on, or that stands on something: it has been cut out.
struct CoveredPart {
    std::string face;
    double area = 0;   ///< cut out
    double whole = 0;  ///< area of the face before
};

/// A face that covers a part of another and sees nothing else. It has no surface, and that part is not among the
/// surfaces of the other.
struct MaskedPart {
    std::string name;
    std::string base;  ///< name of the face that it covers a part of
    double area = 0;
};

/// Surfaces, and the faces (groups of surfaces) that results are reported for.
struct Scene {
    std::string name;       ///< name as the user wrote it, e.g. "cube"
    std::string canonical;  ///< what the scene is, independent of its name; keys the random streams
    std::vector<Surface> surfaces;
    std::vector<std::string> faces;  ///< face labels as reported, e.g. "1" .. "6"
    bool closed = false;             ///< every ray hits something: a ray that does not is lost
    double coordinate_rounding = 0;  ///< how much the coordinates of a file may be off, as far as their digits tell
    double coordinate_step = 0;      ///< of decimals so few that they may be exact or rounded; 0 where there are more
    std::vector<CoveredPart> covered;
    std::vector<MaskedPart> masks;
    std::vector<std::string> remarks;  ///< what reading a file changed or left out, in words
    /// Edge lengths a, b, c where the scene is the inside of [0,a]x[0,b]x[0,c].
    std::optional<Eigen::Vector3d> empty_box;
};

/// Area of a shape, in squared units of length.
double area(const Shape& shape);

/// The corners of a parallelogram or a triangle in order around it; none of a round shape.
std::vector<Eigen::Vector3d> corners(const Shape& shape);

/// Patch number `index` of a parallelogram.
Parallelogram patch(const Parallelogram& shape, Grid grid, std::uint32_t index);

/// Patch number `index` of a surface, as a surface of its own. @pre the surface is a parallelogram
Surface patch(const Surface& surface, Grid grid, std::uint32_t index);

/// The shape of a surface that is known to be a parallelogram.
const Parallelogram& parallelogram(const Surface& surface);
Parallelogram& parallelogram(Surface& surface);

/// Whether every surface is a parallelogram.
bool has_only_parallelograms(const Scene& scene);

/// Whether some surface is divided.
bool has_grids(const Scene& scene);

/// The surfaces of a face.
std::vector<const Surface*> surfaces_of(const Scene& scene, int face);

/// Total area of a face.
double face_area(const Scene& scene, int face);

}  // namespace ff
