#include "core/support/contract.hpp"
#include "core/tracing/rays.hpp"
#include "core/tracing/tracer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/tracing/box_tracer.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h comes first
#include "core/tracing/cosine_rays-inl.h"

#ifndef FF_CORE_BOX_TRACER_ONCE
#define FF_CORE_BOX_TRACER_ONCE
namespace ff {
namespace {

/// Walls of the box as the surface that a ray leaves sees them; `none` is behind it.
enum Wall : std::uint32_t { opposite, low_u, high_u, low_v, high_v, none, walls = none };

/// The box seen from one of its surfaces: it extends along edge_u, edge_v and the normal.
struct LocalBox {
    float extent_u = 0;
    float extent_v = 0;
    float height = 0;
    float inverse_height = 0;
};

using WallHits = std::array<std::uint64_t, walls>;

/// Rays of a batch in the coordinates of the surface that they leave.
struct LocalRays {
    static constexpr std::size_t capacity = 64;
    using Component = std::array<float, capacity>;
    alignas(64) Component origin_u{}, origin_v{}, direction_u{}, direction_v{}, direction_n{};
};

/// Walls found, aligned like the rays.
struct alignas(64) LocalWalls : std::array<std::uint32_t, LocalRays::capacity> {};

}  // namespace
}  // namespace ff
#endif

HWY_BEFORE_NAMESPACE();
namespace ff {
namespace HWY_NAMESPACE {

/// Where rays leave the box: through a wall across u, across v, or (neither) through the opposite one.
struct Exits {
    FloatMask across_u, across_v;
};

/// Compares distances gap / size without dividing; all arguments are at least 0. Equal distances, that is hits on an
/// edge, go to the opposite wall first, then to the wall across v.
HWY_INLINE Exits exits(const LocalBox& box, Floats gap_u, Floats gap_v, Floats size_u, Floats size_v, Floats normal) {
    const auto slope = hn::Mul(normal, hn::Set(FloatTag(), box.inverse_height));
    const auto u_before_opposite = hn::Lt(hn::Mul(gap_u, slope), size_u);
    const auto v_before_opposite = hn::Lt(hn::Mul(gap_v, slope), size_v);
    const auto u_before_v = hn::Lt(hn::Mul(gap_u, size_v), hn::Mul(gap_v, size_u));
    return {.across_u = hn::And(u_before_opposite, u_before_v), .across_v = hn::AndNot(u_before_v, v_before_opposite)};
}

/// Distance along an axis to the wall that the ray approaches.
HWY_INLINE Floats gap(Floats position, float extent, FloatMask negative) {
    return hn::IfThenElse(negative, position, hn::Sub(hn::Set(FloatTag(), extent), position));
}

void shoot_block(const LocalBox& box, const PatchMap& map, const PointBlock& points, WallHits& hits) {
    const FloatTag df;
    const WordTag dw;
    const auto step_u = hn::Set(df, patch_step(box.extent_u, map.grid.columns));
    const auto step_v = hn::Set(df, patch_step(box.extent_v, map.grid.rows));
    std::size_t across_u = 0, across_v = 0, at_low_u = 0, at_low_v = 0;
    const auto add = [&](std::size_t i, const auto... wanted) HWY_ATTR {
        const auto word = [&](std::size_t d) HWY_ATTR { return hn::Load(dw, &points.coordinate[d][i]); };
        const auto u = hn::Mul(place(word(0), map.first_u), step_u);
        const auto v = hn::Mul(place(word(1), map.first_v), step_v);
        const auto d = cosine_direction(word(2), word(3));
        auto [by_u, by_v] = exits(box, gap(u, box.extent_u, d.negative_u), gap(v, box.extent_v, d.negative_v), d.size_u,
                                  d.size_v, d.normal);
        ((by_u = hn::And(by_u, wanted), by_v = hn::And(by_v, wanted)), ...);  // only in the last, partial vector
        across_u += hn::CountTrue(df, by_u);
        across_v += hn::CountTrue(df, by_v);
        at_low_u += hn::CountTrue(df, hn::And(by_u, d.negative_u));
        at_low_v += hn::CountTrue(df, hn::And(by_v, d.negative_v));
    };
    const std::size_t lanes = hn::Lanes(df);
    const std::size_t whole = points.size / lanes * lanes;
    for (std::size_t i = 0; i < whole; i += lanes) add(i);
    if (whole < points.size) add(whole, hn::FirstN(df, points.size - whole));

    hits[opposite] = points.size - across_u - across_v;
    hits[low_u] = at_low_u;
    hits[high_u] = across_u - at_low_u;
    hits[low_v] = at_low_v;
    hits[high_v] = across_v - at_low_v;
}

void find_walls(const LocalBox& box, const LocalRays& rays, LocalWalls& found) {
    const FloatTag df;
    const auto zero = hn::Zero(df);
    for (std::size_t i = 0; i < LocalRays::capacity; i += hn::Lanes(df)) {
        const auto along_u = hn::Load(df, &rays.direction_u[i]);
        const auto along_v = hn::Load(df, &rays.direction_v[i]);
        const auto along_n = hn::Load(df, &rays.direction_n[i]);
        const auto negative_u = hn::Lt(along_u, zero);
        const auto negative_v = hn::Lt(along_v, zero);
        const auto exit = exits(box, gap(hn::Load(df, &rays.origin_u[i]), box.extent_u, negative_u),
                                gap(hn::Load(df, &rays.origin_v[i]), box.extent_v, negative_v), hn::Abs(along_u),
                                hn::Abs(along_v), along_n);
        const auto wall = [](FloatMask choice, Wall yes, Wall no) HWY_ATTR {
            const WordTag dw;
            return hn::IfThenElse(hn::RebindMask(dw, choice), hn::Set(dw, yes), hn::Set(dw, no));
        };
        auto result = hn::Set(WordTag(), opposite);
        const auto choose = [&result](FloatMask when, Words32 then)
                                HWY_ATTR { result = hn::IfThenElse(hn::RebindMask(WordTag(), when), then, result); };
        choose(exit.across_u, wall(negative_u, low_u, high_u));
        choose(exit.across_v, wall(negative_v, low_v, high_v));
        choose(hn::Lt(along_n, zero), hn::Set(WordTag(), none));
        hn::Store(result, WordTag(), &found[i]);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace ff
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ff {
namespace {

HWY_EXPORT(shoot_block);
HWY_EXPORT(find_walls);

/// Surface of the box as the tracer needs it: axes are 0, 1, 2 for x, y, z.
struct BoxSurface {
    std::uint32_t axis_u = 0, axis_v = 0, axis_n = 0;
    bool on_low_side = false;  ///< its plane is coordinate 0 of axis_n, and it looks along the positive axis
    LocalBox box;
    std::array<std::uint32_t, walls> surface_at{};  ///< surface index by Wall
};

std::uint32_t axis_of(const Eigen::Vector3d& along) {
    Eigen::Index axis = 0;
    along.cwiseAbs().maxCoeff(&axis);
    return static_cast<std::uint32_t>(axis);
}

class BoxTracer final : public Tracer {
  public:
    explicit BoxTracer(const Scene& scene);

    [[nodiscard]] std::string_view name() const override { return "box"; }
    void shoot(std::uint32_t source, Grid grid, std::uint32_t patch, const PointBlock& block,
               std::span<std::uint64_t> hits) const override;
    void trace(const RayBatch& rays, std::span<Hit> hits) const override;

  private:
    [[nodiscard]] Hit hit_on(Wall wall, const BoxSurface& from, const std::array<float, 3>& origin,
                             const std::array<float, 3>& direction) const;

    std::array<float, 3> edges_{};
    std::array<BoxSurface, 6> surfaces_;
    std::array<std::size_t, 6> face_of_{};
};

BoxTracer::BoxTracer(const Scene& scene) {
    FF_EXPECT(scene.empty_box.has_value());
    FF_EXPECT(scene.surfaces.size() == surfaces_.size());
    std::array<std::array<std::uint32_t, 2>, 3> surface_at_end{};  // [axis][at the far end]
    for (std::uint32_t i = 0; i < surfaces_.size(); ++i) {
        const Surface& surface = scene.surfaces[i];
        const SurfaceFrame frame = surface_frame(surface);
        BoxSurface& s = surfaces_[i];
        s.axis_u = axis_of(parallelogram(surface).edge_u);
        s.axis_v = axis_of(parallelogram(surface).edge_v);
        s.axis_n = axis_of(surface.normal);
        s.on_low_side = frame.normal[s.axis_n] > 0;
        s.box.extent_u = frame.edge_u[s.axis_u];
        s.box.extent_v = frame.edge_v[s.axis_v];
        s.box.height = static_cast<float>((*scene.empty_box)[s.axis_n]);
        s.box.inverse_height = 1 / s.box.height;
        edges_[s.axis_n] = s.box.height;
        surface_at_end[s.axis_n][s.on_low_side ? 0 : 1] = i;
        face_of_[i] = static_cast<std::size_t>(surface.face);
    }
    for (BoxSurface& s : surfaces_) {
        s.surface_at[opposite] = surface_at_end[s.axis_n][s.on_low_side ? 1 : 0];
        s.surface_at[low_u] = surface_at_end[s.axis_u][0];
        s.surface_at[high_u] = surface_at_end[s.axis_u][1];
        s.surface_at[low_v] = surface_at_end[s.axis_v][0];
        s.surface_at[high_v] = surface_at_end[s.axis_v][1];
    }
}

void BoxTracer::shoot(std::uint32_t source, Grid grid, std::uint32_t patch, const PointBlock& block,
                      std::span<std::uint64_t> hits) const {
    FF_EXPECT(block.dimension == 4);
    FF_EXPECT(block.size <= block_capacity);
    const BoxSurface& from = surfaces_.at(source);
    WallHits at_wall{};
    HWY_DYNAMIC_DISPATCH(shoot_block)(from.box, patch_map(grid, patch), block, at_wall);
    for (std::size_t wall = 0; wall < walls; ++wall) hits[face_of_[from.surface_at[wall]]] += at_wall[wall];
}

Hit BoxTracer::hit_on(Wall wall, const BoxSurface& from, const std::array<float, 3>& origin,
                      const std::array<float, 3>& direction) const {
    if (wall == none) return {};
    const std::uint32_t target = from.surface_at[wall];
    const BoxSurface& to = surfaces_[target];
    const std::uint32_t axis = to.axis_n;
    const float gap = to.on_low_side ? origin[axis] : edges_[axis] - origin[axis];
    const float time = wall == opposite ? from.box.height / std::abs(direction[axis]) : gap / std::abs(direction[axis]);
    const auto coordinate = [&](std::uint32_t along) {
        return std::clamp((origin[along] + time * direction[along]) / edges_[along], 0.0f, 1.0f);
    };
    return {.surface = target, .s = coordinate(to.axis_u), .t = coordinate(to.axis_v)};
}

void BoxTracer::trace(const RayBatch& rays, std::span<Hit> hits) const {
    FF_EXPECT(hits.size() >= rays.size());
    const BoxSurface& from = surfaces_.at(rays.source);
    const std::array origin{&rays.origin_x, &rays.origin_y, &rays.origin_z};
    const std::array direction{&rays.direction_x, &rays.direction_y, &rays.direction_z};
    LocalRays local;
    LocalWalls found{};
    for (std::size_t first = 0; first < rays.size(); first += LocalRays::capacity) {
        const std::size_t count = std::min(LocalRays::capacity, rays.size() - first);
        for (std::size_t i = 0; i < count; ++i) {
            local.origin_u[i] = (*origin[from.axis_u])[first + i];
            local.origin_v[i] = (*origin[from.axis_v])[first + i];
            local.direction_u[i] = (*direction[from.axis_u])[first + i];
            local.direction_v[i] = (*direction[from.axis_v])[first + i];
            const float upwards = (*direction[from.axis_n])[first + i];
            local.direction_n[i] = from.on_low_side ? upwards : -upwards;
        }
        HWY_DYNAMIC_DISPATCH(find_walls)(from.box, local, found);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t ray = first + i;
            hits[ray] =
                hit_on(static_cast<Wall>(found[i]), from, {rays.origin_x[ray], rays.origin_y[ray], rays.origin_z[ray]},
                       {rays.direction_x[ray], rays.direction_y[ray], rays.direction_z[ray]});
        }
    }
}

}  // namespace

std::unique_ptr<Tracer> make_box_tracer(const Scene& scene) {
    return std::make_unique<BoxTracer>(scene);
}

}  // namespace ff
#endif  // HWY_ONCE
