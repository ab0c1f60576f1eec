#pragma once

#include "core/points.hpp"
#include "core/scene.hpp"

#include <array>
#include <cstdint>

namespace ff {

/// A surface in single precision, with the directions that rays are built from: `tangent` along edge_u, `bitangent`
/// perpendicular to it on the side of edge_v, and the normal, all of unit length.
struct SurfaceFrame {
    using Vector = std::array<float, 3>;
    Vector corner, edge_u, edge_v;
    Vector tangent, bitangent, normal;
};

/// @throws UserError where a coordinate is not finite in single precision
SurfaceFrame surface_frame(const Surface& surface);

/// A patch as the affine map from 24-bit coordinates x to surface coordinates: s = (column + x) * scale.
/// All three are scaled by a power of two, so that the conversion from integers needs no multiplication of its own.
struct PatchMap {
    float column = 0;  ///< column * 2^24
    float row = 0;     ///< row * 2^24
    float scale = 0;   ///< 2^-24 / m
};

PatchMap patch_map(Subdivision subdivision, std::uint32_t patch);

/// Rays of one block, one array a component, in the first-level cache.
struct RayBlock {
    using Component = std::array<float, block_capacity>;
    alignas(64) Component origin_x, origin_y, origin_z;
    alignas(64) Component direction_x, direction_y, direction_z;
};

/// One ray for each point of the block; what `Tracer::shoot` shoots and `generate_rays` stores. Up to a whole vector
/// past the size of the block may be written.
void generate_ray_block(const SurfaceFrame& frame, const PatchMap& map, const PointBlock& points, RayBlock& rays);

}  // namespace ff
