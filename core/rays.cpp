#include "core/rays.hpp"

#include "core/contract.hpp"
#include "core/error.hpp"
#include "core/tracer.hpp"

#include <cmath>
#include <memory>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/rays.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h comes first
#include "core/cosine_rays-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ff {
namespace HWY_NAMESPACE {

/// (base + s * along_s) + t * along_t: the one order of additions.
HWY_INLINE Floats on_plane(float base, Floats s, float along_s, Floats t, float along_t) {
    const FloatTag df;
    return hn::Add(hn::Add(hn::Set(df, base), hn::Mul(s, hn::Set(df, along_s))), hn::Mul(t, hn::Set(df, along_t)));
}

HWY_INLINE Floats in_frame(const SurfaceFrame& frame, std::size_t axis, Floats u, Floats v, Floats n) {
    const FloatTag df;
    return hn::Add(
        hn::Add(hn::Mul(u, hn::Set(df, frame.tangent[axis])), hn::Mul(v, hn::Set(df, frame.bitangent[axis]))),
        hn::Mul(n, hn::Set(df, frame.normal[axis])));
}

void generate(const SurfaceFrame& frame, const PatchMap& map, const PointBlock& points, RayBlock& rays) {
    const FloatTag df;
    const WordTag dw;
    const auto unit = hn::Set(df, 0x1p-24f);  // exact: only the exponents change
    const auto minus_unit = hn::Set(df, -0x1p-24f);
    RayBlock::Component* const origin[] = {&rays.origin_x, &rays.origin_y, &rays.origin_z};
    RayBlock::Component* const direction[] = {&rays.direction_x, &rays.direction_y, &rays.direction_z};
    for (std::size_t i = 0; i < points.size; i += hn::Lanes(df)) {
        const auto word = [&](std::size_t d) HWY_ATTR { return hn::Load(dw, &points.coordinate[d][i]); };
        const auto s = surface_coordinate(word(0), map.column, map.scale);
        const auto t = surface_coordinate(word(1), map.row, map.scale);
        const auto local = cosine_direction(word(2), word(3));
        const auto u = hn::Mul(local.size_u, hn::IfThenElse(local.negative_u, minus_unit, unit));
        const auto v = hn::Mul(local.size_v, hn::IfThenElse(local.negative_v, minus_unit, unit));
        const auto n = hn::Mul(local.normal, unit);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            hn::Store(on_plane(frame.corner[axis], s, frame.edge_u[axis], t, frame.edge_v[axis]), df,
                      &(*origin[axis])[i]);
            hn::Store(in_frame(frame, axis, u, v, n), df, &(*direction[axis])[i]);
        }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace ff
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ff {
namespace {

SurfaceFrame::Vector to_single(const Eigen::Vector3d& v) {
    const Eigen::Vector3f single = v.cast<float>();
    if (!single.allFinite()) {
        throw UserError(
            "scene: a length is beyond 3.4e38 (rays are traced in single precision). Use a larger unit of length.");
    }
    return {single.x(), single.y(), single.z()};
}

}  // namespace

SurfaceFrame surface_frame(const Surface& surface) {
    const auto& [corner, edge_u, edge_v] = surface.shape;
    const Eigen::Vector3d tangent = edge_u.normalized();
    const Eigen::Vector3d bitangent = (edge_v - edge_v.dot(tangent) * tangent).normalized();
    return {.corner = to_single(corner),
            .edge_u = to_single(edge_u),
            .edge_v = to_single(edge_v),
            .tangent = to_single(tangent),
            .bitangent = to_single(bitangent),
            .normal = to_single(surface.normal)};
}

PatchMap patch_map(Subdivision subdivision, std::uint32_t patch) {
    FF_EXPECT(patch < subdivision.per_surface());
    // m * fl(1/m) rounds to at most 1, so surface coordinates never leave [0, 1].
    return {.column = 0x1p24f * static_cast<float>(patch % subdivision.m),
            .row = 0x1p24f * static_cast<float>(patch / subdivision.m),
            .scale = 0x1p-24f / static_cast<float>(subdivision.m)};
}

HWY_EXPORT(generate);

void generate_ray_block(const SurfaceFrame& frame, const PatchMap& map, const PointBlock& points, RayBlock& rays) {
    FF_EXPECT(points.dimension == 4);
    FF_EXPECT(points.size <= block_capacity);
    HWY_DYNAMIC_DISPATCH(generate)(frame, map, points, rays);
}

void generate_rays(const Surface& surface, std::uint32_t source, Subdivision subdivision, std::uint32_t patch,
                   const PointBlock& block, RayBatch& rays) {
    const auto generated = std::make_unique<RayBlock>();
    generate_ray_block(surface_frame(surface), patch_map(subdivision, patch), block, *generated);
    const auto take = [&block](const RayBlock::Component& from, std::vector<float>& to) {
        to.assign(from.begin(), from.begin() + static_cast<std::ptrdiff_t>(block.size));
    };
    take(generated->origin_x, rays.origin_x);
    take(generated->origin_y, rays.origin_y);
    take(generated->origin_z, rays.origin_z);
    take(generated->direction_x, rays.direction_x);
    take(generated->direction_y, rays.direction_y);
    take(generated->direction_z, rays.direction_z);
    rays.source = source;
}

}  // namespace ff
#endif  // HWY_ONCE
