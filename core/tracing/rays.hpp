#pragma once

#include "core/geometry/line_meets.hpp"
#include "core/geometry/scene.hpp"
#include "core/geometry/subdivision.hpp"
#include "core/points/points.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace ff {

/// How much nearer to the middle of its surface the second attempt of a ray starts, and how much rims are enlarged for
/// it.
inline constexpr double second_attempt = 0x1p-20;

/// Whether a ray begins on its source, and cannot meet it there. In a second attempt it starts inside of a hollow one.
inline bool begins_on(const Surface& source, double rim) {
    return rim == 0 || is_flat(source.shape) || facing(source.shape) == Facing::outward;
}

/// Whether a ray arrives at the back of a surface. @param outward  Meeting::outward
inline bool meets_back(const Surface& surface, bool outward, const Eigen::Vector3d& direction) {
    if (is_flat(surface.shape)) return surface.normal.dot(direction) >= 0;
    return (facing(surface.shape) == Facing::inward) != outward;
}

/// A parallelogram in single precision, with the directions that rays are built from: `tangent` along edge_u,
/// `bitangent` perpendicular to it on the side of edge_v, and the normal, all of unit length.
struct SurfaceFrame {
    using Vector = std::array<float, 3>;
    Vector corner, edge_u, edge_v;
    Vector tangent, bitangent, normal;
};

/// @throws UserError where a coordinate is not finite in single precision
/// @pre a parallelogram
SurfaceFrame surface_frame(const Surface& surface);

/// Where a patch lies in the grid of its surface. A coordinate x of a point becomes the fraction of a float, 1 + x;
/// `first_u` subtracts the 1, adds the column and half of the last bit.
struct PatchMap {
    float first_u = 0;  ///< column - 1 + 2^-24
    float first_v = 0;  ///< row - 1 + 2^-24
    Grid grid = undivided;
};

PatchMap patch_map(Grid grid, std::uint32_t patch);

/// Length of one of several equal parts of an edge, rounded such that together they are not longer than the edge: no
/// ray starts outside its surface.
float patch_step(float edge, std::uint32_t parts);

/// Rays of one block, one array per component, in the first-level cache.
struct RayBlock {
    using Component = std::array<float, block_capacity>;
    alignas(64) Component origin_x, origin_y, origin_z;
    alignas(64) Component direction_x, direction_y, direction_z;
};

/// One ray for each point of the block; `Tracer::shoot` shoots and `generate_rays` stores them. Up to one whole vector
/// past the size of the block may be written. Rays of parallelograms are computed in single precision and vectorised;
/// those of other shapes in double precision, one by one, with origins at all 32 bits of a coordinate.
/// @throws UserError where the surface does not fit single precision
void generate_ray_block(const Surface& surface, Grid grid, std::uint32_t patch, const PointBlock& points,
                        RayBlock& rays);

/// The same rays in double precision, as lines: directions are computed as for round shapes, on parallelograms too;
/// origins lie on the surface up to rounding in double precision.
void generate_lines(const Surface& surface, Grid grid, std::uint32_t patch, const PointBlock& points,
                    std::vector<Line>& lines);

/// The components of rays: origins, then directions.
template <class Rays>
auto components_of(Rays& rays) {
    return std::array{&rays.origin_x,    &rays.origin_y,    &rays.origin_z,
                      &rays.direction_x, &rays.direction_y, &rays.direction_z};
}

/// Pointers to components of consecutive rays.
using RayPointers = std::array<const float*, 6>;

template <class Rays>
RayPointers pointers_to(const Rays& rays) {
    RayPointers pointers{};
    std::size_t next = 0;
    for (const auto* component : components_of(rays)) pointers[next++] = component->data();
    return pointers;
}

inline Eigen::Vector3d direction_of(const RayPointers& rays, std::size_t i) {
    return {rays[3][i], rays[4][i], rays[5][i]};
}

inline Line line_of(const RayPointers& rays, std::size_t i) {
    return {{rays[0][i], rays[1][i], rays[2][i]}, direction_of(rays, i)};
}

/// The largest coordinate of a surface, in the units of the scene.
/// @throws UserError where one is not finite in single precision
double largest_coordinate(const Surface& surface);

}  // namespace ff
