#include "tests/validation/form_factors/facet_scenes.hpp"

#include "core/geometry/scene.hpp"
#include "stats/basics/resampling.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>

namespace ff::studies::form_factors {
namespace {

using Eigen::Vector3d;

/// Collects facets, which radiate to the side that their corners are counter-clockwise from.
class FacetBuilder {
  public:
    explicit FacetBuilder(std::string name) {
        scene_.name = name;
        scene_.canonical = std::move(name);
        scene_.closed = true;
    }

    /// Divides a parallelogram that radiates along u x v.
    void add_wall(const Vector3d& corner, const Vector3d& u, const Vector3d& v, Grid grid) {
        const auto at = [&](std::uint32_t i, std::uint32_t j) {
            return Vector3d(corner + u * (double{1} * i / grid.columns) + v * (double{1} * j / grid.rows));
        };
        for (std::uint32_t i = 0; i < grid.columns; ++i) {
            for (std::uint32_t j = 0; j < grid.rows; ++j)
                add(Parallelogram{at(i, j), at(i + 1, j) - at(i, j), at(i, j + 1) - at(i, j)}, u.cross(v));
        }
    }

    void add_triangle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
        add(Triangle{a, b, c}, (b - a).cross(c - a));
    }

    /// @param counts  of squares along each axis @param sides  that are left out are not divided
    void add_box(const Vector3d& low, const Vector3d& size, const std::array<std::uint32_t, 3>& counts, Facing facing,
                 bool has_bottom = true) {
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            const Eigen::Index a = (axis + 1) % 3;
            const Eigen::Index b = (axis + 2) % 3;
            const auto count = [&](Eigen::Index k) { return counts.at(static_cast<std::size_t>(k)); };
            for (const bool far : {false, true}) {
                if (!has_bottom && axis == 2 && !far) continue;
                const Vector3d corner = far ? Vector3d(low + size[axis] * Vector3d::Unit(axis)) : low;
                const Vector3d u = size[a] * Vector3d::Unit(a);
                const Vector3d v = size[b] * Vector3d::Unit(b);
                if (far == (facing == Facing::outward))
                    add_wall(corner, u, v, {count(a), count(b)});
                else
                    add_wall(corner, v, u, {count(b), count(a)});
            }
        }
    }

    [[nodiscard]] Scene open() && {
        scene_.closed = false;
        return std::move(scene_);
    }
    [[nodiscard]] Scene closed() && { return std::move(scene_); }

  private:
    Scene scene_;

    void add(const Shape& shape, const Vector3d& normal) {
        const int face = static_cast<int>(scene_.faces.size());
        scene_.surfaces.push_back({shape, normal.normalized(), face});
        scene_.faces.push_back(std::to_string(face + 1));
    }
};

}  // namespace

Scene nested_cubes_of_facets(std::uint32_t outer, std::uint32_t inner) {
    FacetBuilder scene(fmt::format("nested {} {}", outer, inner));
    scene.add_box(Vector3d::Zero(), Vector3d::Ones(), {outer, outer, outer}, Facing::inward);
    scene.add_box(Vector3d::Constant(0.25), Vector3d::Constant(0.5), {inner, inner, inner}, Facing::outward);
    return std::move(scene).closed();
}

Scene city_of_facets(std::uint32_t buildings, std::uint32_t divisions) {
    FacetBuilder scene(fmt::format("city {} {}", buildings, divisions));
    stats::Draws draws(derive_key(Seed{1999}, "city of facets"), stats::Resampling::simulation, 0);
    for (std::uint32_t i = 0; i <= 2 * buildings; ++i) {
        for (std::uint32_t j = 0; j <= 2 * buildings; ++j) {
            const Vector3d corner(i, j, 0);
            if (i % 2 == 1 && j % 2 == 1) {
                const auto floors = static_cast<std::uint32_t>(1 + draws.below(std::size_t{3} * divisions));
                scene.add_box(corner, {1, 1, double{1} * floors / divisions}, {divisions, divisions, floors},
                              Facing::outward, false);
            } else {
                const std::uint32_t squares = divisions / 2 > 0 ? divisions / 2 : 1;
                scene.add_wall(corner, Vector3d::UnitX(), Vector3d::UnitY(), {squares, squares});
            }
        }
    }
    return std::move(scene).open();
}

Scene l_room_of_facets(std::uint32_t divisions) {
    FacetBuilder scene(fmt::format("L-room {}", divisions));
    const Vector3d x = Vector3d::UnitX();
    const Vector3d y = Vector3d::UnitY();
    const Vector3d z = Vector3d::UnitZ();
    const Grid square{divisions, divisions};
    for (const Vector3d& quarter : {Vector3d(0, 0, 0), x, y}) {
        scene.add_wall(quarter, x, y, square);
        scene.add_wall(quarter + z, y, x, square);
    }
    scene.add_wall(2 * x, -2 * x, z, {2 * divisions, divisions});
    scene.add_wall(Vector3d::Zero(), 2 * y, z, {2 * divisions, divisions});
    scene.add_wall(2 * x + y, -y, z, square);
    scene.add_wall(x + y, x, z, square);
    scene.add_wall(x + 2 * y, -y, z, square);
    scene.add_wall(2 * y, x, z, square);
    return std::move(scene).closed();
}

Scene bumpy_sphere_of_facets(std::uint32_t rings, std::uint32_t divisions) {
    FacetBuilder scene(fmt::format("bumpy sphere {} {}", rings, divisions));
    scene.add_box(Vector3d::Constant(-1), Vector3d::Constant(2), {divisions, divisions, divisions}, Facing::inward);
    const auto at = [&](std::uint32_t ring, std::uint32_t meridian) {
        const double polar = std::numbers::pi * ring / rings;
        const double azimuth = std::numbers::pi * (meridian % (2 * rings)) / rings;
        const bool is_pole = ring == 0 || ring == rings;
        const double radius = is_pole ? 0.5 : 0.5 * (1 + 0.15 * std::sin(3 * polar) * std::cos(2 * azimuth));
        if (is_pole) return Vector3d(0, 0, ring == 0 ? radius : -radius);
        return Vector3d(radius * std::sin(polar) * std::cos(azimuth), radius * std::sin(polar) * std::sin(azimuth),
                        radius * std::cos(polar));
    };
    for (std::uint32_t i = 0; i < rings; ++i) {
        for (std::uint32_t j = 0; j < 2 * rings; ++j) {
            if (i + 1 < rings) scene.add_triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
            if (i > 0) scene.add_triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
        }
    }
    return std::move(scene).closed();
}

std::vector<Scene> facet_scenes(FacetScenes sizes) {
    if (sizes == FacetScenes::small)
        return {nested_cubes_of_facets(4, 2), l_room_of_facets(2), city_of_facets(2, 2), bumpy_sphere_of_facets(3, 2)};
    return {nested_cubes_of_facets(9, 3), l_room_of_facets(5), city_of_facets(3, 2), bumpy_sphere_of_facets(6, 4)};
}

}  // namespace ff::studies::form_factors
