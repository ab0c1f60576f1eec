#pragma once

#include "core/shape.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ff {

/// No face: a surface that only stands in the way. Rays end there and are counted nowhere.
inline constexpr int no_face = -1;

/// One piece of a scene's boundary. It radiates and receives on one side only: that of `normal` (unit length) where it
/// is flat, that of its `facing` where it is curved (`normal` is then 0).
struct Surface {
    Shape shape;
    Eigen::Vector3d normal;
    int face = 0;  ///< index into Scene::faces, no_face or mirror_face (core/mirrors.hpp)
};

/// Surfaces, and the faces (groups of surfaces) that results are reported for.
struct Scene {
    std::string name;       ///< as the user wrote it, e.g. "cube"
    std::string canonical;  ///< what the scene is, independent of its name; keys the random streams
    std::vector<Surface> surfaces;
    std::vector<std::string> faces;  ///< face labels as reported, e.g. "1" .. "6"
    bool closed = false;             ///< every ray hits something: a ray that does not is lost
    std::optional<Eigen::Vector3d>
        empty_box;  ///< edge lengths a, b, c where the scene is the inside of [0,a]x[0,b]x[0,c]
};

/// m x m patches of equal area on every surface. Patch k*m*m + row*m + column lies on surface k, at s in
/// [column/m, (column+1)/m] and t in [row/m, (row+1)/m]: on a parallelogram, along edge_u and edge_v.
struct Subdivision {
    std::uint32_t m = 1;

    [[nodiscard]] std::uint32_t per_surface() const { return m * m; }
    [[nodiscard]] std::uint32_t patches(const Scene& scene) const {
        return per_surface() * static_cast<std::uint32_t>(scene.surfaces.size());
    }
};

/// Area of a shape, in squared units of length.
double area(const Parallelogram& shape);
double area(const Shape& shape);

/// The corners of a parallelogram or a triangle in order around it; none of a round shape.
std::vector<Eigen::Vector3d> corners(const Shape& shape);

/// Patch `index` (0 .. m*m-1) of a surface.
Parallelogram patch(const Parallelogram& shape, Subdivision subdivision, std::uint32_t index);

/// The shape of a surface that is known to be a parallelogram.
const Parallelogram& parallelogram(const Surface& surface);
Parallelogram& parallelogram(Surface& surface);

/// Whether every surface is a parallelogram.
bool has_only_parallelograms(const Scene& scene);

/// Total area of a face.
double face_area(const Scene& scene, int face);

}  // namespace ff
