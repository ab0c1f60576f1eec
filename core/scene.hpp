#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ff {

/// The points corner + s * edge_u + t * edge_v with 0 <= s, t <= 1. Lengths in the scene's unit.
struct Parallelogram {
    Eigen::Vector3d corner;
    Eigen::Vector3d edge_u;
    Eigen::Vector3d edge_v;
};

/// One piece of a scene's boundary. It radiates and receives on the side of `normal` (unit length) only.
struct Surface {
    Parallelogram shape;
    Eigen::Vector3d normal;
    int face = 0;  ///< index into Scene::faces
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

/// m x m equal patches on every surface. Patch s*m*m + row*m + column lies on surface s, at
/// [column/m, (column+1)/m] along edge_u and [row/m, (row+1)/m] along edge_v.
struct Subdivision {
    std::uint32_t m = 1;

    [[nodiscard]] std::uint32_t per_surface() const { return m * m; }
    [[nodiscard]] std::uint32_t patches(const Scene& scene) const {
        return per_surface() * static_cast<std::uint32_t>(scene.surfaces.size());
    }
};

/// Area of a parallelogram, in squared units of length.
double area(const Parallelogram& shape);

/// Patch `index` (0 .. m*m-1) of a surface.
Parallelogram patch(const Parallelogram& shape, Subdivision subdivision, std::uint32_t index);

/// Total area of a face.
double face_area(const Scene& scene, int face);

}  // namespace ff
