#include "core/tracing/rays.hpp"

#include "core/geometry/surface_map.hpp"
#include "core/support/contract.hpp"
#include "core/support/error.hpp"
#include "core/tracing/tracer.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <memory>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/tracing/rays.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h comes first
#include "core/tracing/cosine_rays-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ff {
namespace HWY_NAMESPACE {

/// (corner + place_u * step_u) + place_v * step_v: the one order of additions.
HWY_INLINE Floats on_plane(float corner, Floats place_u, float step_u, Floats place_v, float step_v) {
    const FloatTag df;
    return hn::Add(hn::Add(hn::Set(df, corner), hn::Mul(place_u, hn::Set(df, step_u))),
                   hn::Mul(place_v, hn::Set(df, step_v)));
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
    SurfaceFrame::Vector step_u, step_v;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        step_u[axis] = patch_step(frame.edge_u[axis], map.grid.columns);
        step_v[axis] = patch_step(frame.edge_v[axis], map.grid.rows);
    }
    const std::array origin{&rays.origin_x, &rays.origin_y, &rays.origin_z};
    const std::array direction{&rays.direction_x, &rays.direction_y, &rays.direction_z};
    for (std::size_t i = 0; i < points.size; i += hn::Lanes(df)) {
        const auto word = [&](std::size_t d) HWY_ATTR { return hn::Load(dw, &points.coordinate[d][i]); };
        const auto place_u = place(word(0), map.first_u);
        const auto place_v = place(word(1), map.first_v);
        const auto local = cosine_direction(word(2), word(3));
        const auto u = hn::IfThenElse(local.negative_u, hn::Neg(local.size_u), local.size_u);
        const auto v = hn::IfThenElse(local.negative_v, hn::Neg(local.size_v), local.size_v);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            hn::Store(on_plane(frame.corner[axis], place_u, step_u[axis], place_v, step_v[axis]), df,
                      &(*origin[axis])[i]);
            hn::Store(in_frame(frame, axis, u, v, local.normal), df, &(*direction[axis])[i]);
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
    const auto& [corner, edge_u, edge_v] = parallelogram(surface);
    const Eigen::Vector3d tangent = edge_u.normalized();
    const Eigen::Vector3d bitangent = (edge_v - edge_v.dot(tangent) * tangent).normalized();
    return {.corner = to_single(corner),
            .edge_u = to_single(edge_u),
            .edge_v = to_single(edge_v),
            .tangent = to_single(tangent),
            .bitangent = to_single(bitangent),
            .normal = to_single(surface.normal)};
}

PatchMap patch_map(Grid grid, std::uint32_t patch) {
    FF_EXPECT(patch < grid.parts());
    const auto first = [](std::uint32_t place) { return static_cast<float>(place) - (1 - 0x1p-24f); };
    return {.first_u = first(patch % grid.columns), .first_v = first(patch / grid.columns), .grid = grid};
}

float patch_step(float edge, std::uint32_t parts) {
    const auto count = static_cast<float>(parts);
    const float step = edge / count;
    return std::abs(step * count) > std::abs(edge) ? std::nextafter(step, 0.0f) : step;
}

HWY_EXPORT(generate);

namespace {

/// Rays that leave the origin around the z axis.
constexpr SurfaceFrame upright{.corner = {0, 0, 0},
                               .edge_u = {0, 0, 0},
                               .edge_v = {0, 0, 0},
                               .tangent = {1, 0, 0},
                               .bitangent = {0, 1, 0},
                               .normal = {0, 0, 1}};

/// Rays around the z axis, moved to the places of a surface that their points stand for and turned to the normals
/// there: visit(i, origin, direction).
template <class Visit>
void place_rays(const Surface& surface, Grid grid, std::uint32_t patch, const PointBlock& points, const RayBlock& rays,
                Visit visit) {
    const SurfaceMap map(surface);
    const std::uint32_t column = patch % grid.columns;
    const std::uint32_t row = patch / grid.columns;
    const auto coordinate = [&](std::size_t d, std::size_t i) { return (points.coordinate[d][i] + 0.5) * 0x1p-32; };
    // On a parallelogram azimuths lead from edge_u towards edge_v, whichever side radiates.
    const auto* flat = std::get_if<Parallelogram>(&surface.shape);
    const bool turned = flat != nullptr && flat->edge_u.cross(flat->edge_v).dot(surface.normal) < 0;
    for (std::size_t i = 0; i < points.size; ++i) {
        const SurfacePoint point =
            map.at((column + coordinate(0, i)) / grid.columns, (row + coordinate(1, i)) / grid.rows);
        const Eigen::Vector3d bitangent =
            turned ? point.tangent.cross(point.normal) : point.normal.cross(point.tangent);
        visit(i, point.position,
              Eigen::Vector3d(static_cast<double>(rays.direction_x[i]) * point.tangent +
                              static_cast<double>(rays.direction_y[i]) * bitangent +
                              static_cast<double>(rays.direction_z[i]) * point.normal));
    }
}

}  // namespace

double largest_coordinate(const Surface& surface) {
    double largest = 0;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const Extent along = extent(surface, Eigen::Vector3d::Unit(axis));
        static_cast<void>(to_single({along.low, along.high, along.high - along.low}));
        largest = std::max({largest, std::abs(along.low), std::abs(along.high)});
    }
    return largest;
}

void generate_ray_block(const Surface& surface, Grid grid, std::uint32_t patch, const PointBlock& points,
                        RayBlock& rays) {
    FF_EXPECT(points.dimension == 4);
    FF_EXPECT(points.size <= block_capacity);
    const bool vectorised = std::holds_alternative<Parallelogram>(surface.shape);
    const SurfaceFrame frame = vectorised ? surface_frame(surface) : upright;
    HWY_DYNAMIC_DISPATCH(generate)(frame, patch_map(grid, patch), points, rays);
    if (vectorised) return;
    const auto components = components_of(rays);
    place_rays(surface, grid, patch, points, rays,
               [&](std::size_t i, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
                   for (std::size_t axis = 0; axis < 3; ++axis) {
                       (*components[axis])[i] = static_cast<float>(from[static_cast<Eigen::Index>(axis)]);
                       (*components[axis + 3])[i] = static_cast<float>(to[static_cast<Eigen::Index>(axis)]);
                   }
               });
}

void generate_lines(const Surface& surface, Grid grid, std::uint32_t patch, const PointBlock& points,
                    std::vector<Line>& lines) {
    FF_EXPECT(points.dimension == 4);
    FF_EXPECT(points.size <= block_capacity);
    const auto rays = std::make_unique<RayBlock>();
    HWY_DYNAMIC_DISPATCH(generate)(upright, patch_map(undivided, 0), points, *rays);
    lines.resize(points.size);
    place_rays(surface, grid, patch, points, *rays,
               [&](std::size_t i, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
                   lines[i] = {from, to};
               });
}

void generate_rays(const Surface& surface, std::uint32_t source, Grid grid, std::uint32_t patch,
                   const PointBlock& block, RayBatch& rays) {
    const auto generated = std::make_unique<RayBlock>();
    generate_ray_block(surface, grid, patch, block, *generated);
    const auto to = components_of(rays);
    for (std::size_t c = 0; c < to.size(); ++c) {
        const RayBlock::Component& from = *components_of(*generated)[c];
        to[c]->assign(from.begin(), from.begin() + static_cast<std::ptrdiff_t>(block.size));
    }
    rays.source = source;
}

}  // namespace ff
#endif  // HWY_ONCE
