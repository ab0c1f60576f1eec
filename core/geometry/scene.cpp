#include "core/geometry/scene.hpp"

#include "core/support/contract.hpp"
#include "core/support/overloaded.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace ff {

double area(const Shape& shape) {
    using std::numbers::pi;
    return std::visit(
        Overloaded{
            [](const Parallelogram& p) { return p.edge_u.cross(p.edge_v).norm(); },
            [](const Triangle& p) { return (p.b - p.a).cross(p.c - p.a).norm() / 2; },
            [](const Disc& p) { return pi * (p.outer_radius - p.inner_radius) * (p.outer_radius + p.inner_radius); },
            [](const Frustum& p) {
                return pi * (p.base_radius + p.top_radius) * std::hypot(p.axis.norm(), p.top_radius - p.base_radius);
            },
            [](const SphereZone& p) { return 2 * pi * p.radius * p.radius * (p.high - p.low); },
        },
        shape);
}

std::vector<Eigen::Vector3d> corners(const Shape& shape) {
    if (const auto* p = std::get_if<Parallelogram>(&shape)) {
        return {p->corner, p->corner + p->edge_u, p->corner + p->edge_u + p->edge_v, p->corner + p->edge_v};
    }
    if (const auto* p = std::get_if<Triangle>(&shape)) return {p->a, p->b, p->c};
    return {};
}

std::uint64_t Subdivision::patches(const Scene& scene) const {
    std::uint64_t parts = 0;
    for (const Surface& surface : scene.surfaces) parts += surface.grid.parts();
    return parts * per_part();
}

Parallelogram patch(const Parallelogram& shape, Grid grid, std::uint32_t index) {
    FF_EXPECT(grid.columns >= 1 && grid.rows >= 1);
    FF_EXPECT(index < grid.parts());
    const double columns = grid.columns;
    const double rows = grid.rows;
    const std::uint32_t whole_rows = index / grid.columns;
    const double column = index % grid.columns;
    const double row = whole_rows;
    return {shape.corner + shape.edge_u * column / columns + shape.edge_v * row / rows, shape.edge_u / columns,
            shape.edge_v / rows};
}

Surface patch(const Surface& surface, Grid grid, std::uint32_t index) {
    return {patch(parallelogram(surface), grid, index), surface.normal, surface.face};
}

const Parallelogram& parallelogram(const Surface& surface) {
    const auto* shape = std::get_if<Parallelogram>(&surface.shape);
    FF_EXPECT(shape != nullptr);
    return *shape;
}

Parallelogram& parallelogram(Surface& surface) {
    auto* shape = std::get_if<Parallelogram>(&surface.shape);
    FF_EXPECT(shape != nullptr);
    return *shape;
}

bool has_only_parallelograms(const Scene& scene) {
    return std::all_of(scene.surfaces.begin(), scene.surfaces.end(),
                       [](const Surface& surface) { return std::holds_alternative<Parallelogram>(surface.shape); });
}

bool has_grids(const Scene& scene) {
    return std::any_of(scene.surfaces.begin(), scene.surfaces.end(),
                       [](const Surface& surface) { return surface.grid != undivided; });
}

std::vector<const Surface*> surfaces_of(const Scene& scene, int face) {
    std::vector<const Surface*> own;
    for (const Surface& surface : scene.surfaces) {
        if (surface.face == face) own.push_back(&surface);
    }
    return own;
}

double face_area(const Scene& scene, int face) {
    FF_EXPECT(face >= 0 && static_cast<std::size_t>(face) < scene.faces.size());
    double sum = 0;
    for (const Surface& surface : scene.surfaces) {
        if (surface.face == face) sum += area(surface.shape);
    }
    return sum;
}

}  // namespace ff
