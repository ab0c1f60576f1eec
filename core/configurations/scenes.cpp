#include "core/configurations/scenes.hpp"

#include "core/geometry/scene.hpp"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace ff::configuration_scenes {
namespace {

using Eigen::Vector3d;

const Vector3d x_axis = Vector3d::UnitX();
const Vector3d y_axis = Vector3d::UnitY();
const Vector3d z_axis = Vector3d::UnitZ();

/// Radiates to where u, v and the normal are right-handed.
Surface rectangle(int face, const Vector3d& corner, const Vector3d& u, const Vector3d& v) {
    return {Parallelogram{corner, u, v}, u.cross(v).normalized(), face};
}

/// Radiates to where a, b, c are seen counter-clockwise.
Surface triangle(int face, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    return {Triangle{a, b, c}, (b - a).cross(c - a).normalized(), face};
}

Surface disc(int face, double height, double radius, const Vector3d& normal) {
    return {Disc{height * z_axis, 0, radius}, normal, face};
}

Surface sphere(int face, double radius, double low, double high, Facing facing) {
    return {SphereZone{Vector3d::Zero(), z_axis, radius, low, high, facing}, Vector3d::Zero(), face};
}

Surface wall(int face, double height, double base_radius, double top_radius) {
    return {Frustum{Vector3d::Zero(), height * z_axis, base_radius, top_radius, Facing::inward}, Vector3d::Zero(),
            face};
}

/// The six faces of a cube from `low` to `high` on every axis, radiating inward (side 1) or outward (side -1); entry i
/// of `faces` belongs to z = low, y = low, z = high, y = high, x = low, x = high.
std::vector<Surface> cube(double low, double high, double side, const std::array<int, 6>& faces) {
    const double edge = high - low;
    const Vector3d origin = Vector3d::Constant(low);
    const Vector3d end = Vector3d::Constant(high);
    std::vector<Surface> surfaces{rectangle(faces[0], origin, edge * x_axis, edge * y_axis),
                                  rectangle(faces[1], origin, edge * z_axis, edge * x_axis),
                                  rectangle(faces[2], end, -edge * y_axis, -edge * x_axis),
                                  rectangle(faces[3], end, -edge * x_axis, -edge * z_axis),
                                  rectangle(faces[4], origin, edge * y_axis, edge * z_axis),
                                  rectangle(faces[5], end, -edge * z_axis, -edge * y_axis)};
    for (Surface& surface : surfaces) surface.normal *= side;
    return surfaces;
}

Scene scene_of(std::vector<Surface> surfaces, int faces, bool closed) {
    Scene scene;
    scene.surfaces = std::move(surfaces);
    for (int face = 1; face <= faces; ++face) scene.faces.push_back(std::to_string(face));
    scene.closed = closed;
    return scene;
}

}  // namespace

Scene parallel_rectangles(double x, double y, double gap) {
    return scene_of(
        {rectangle(0, Vector3d::Zero(), x * x_axis, y * y_axis), rectangle(1, gap * z_axis, y * y_axis, x * x_axis)}, 2,
        false);
}

Scene rectangles_at_angle(double edge, double from, double to, double degrees) {
    // Exact at a right angle, so that the closed form applies.
    const double angle = degrees * std::numbers::pi / 180;
    const Vector3d up = degrees == 90 ? z_axis : std::cos(angle) * y_axis + std::sin(angle) * z_axis;
    return scene_of({rectangle(0, Vector3d::Zero(), edge * x_axis, from * y_axis),
                     rectangle(1, Vector3d::Zero(), to * up, edge * x_axis)},
                    2, false);
}

Scene tetrahedron() {
    const Vector3d a(1, 1, 1);
    const Vector3d b(1, -1, -1);
    const Vector3d c(-1, 1, -1);
    const Vector3d d(-1, -1, 1);
    return scene_of({triangle(0, a, c, b), triangle(1, a, d, c), triangle(2, a, b, d), triangle(3, b, c, d)}, 4, true);
}

Scene parallel_right_triangles() {
    return scene_of({triangle(0, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}), triangle(1, {1, 0, 0}, {1, 1, 0}, {0, 1, 0})}, 2,
                    false);
}

Scene coaxial_discs(double r1, double r2, double distance) {
    return scene_of({disc(0, 0, r1, z_axis), disc(1, distance, r2, -z_axis)}, 2, false);
}

Scene sphere_to_disc() {
    return scene_of({sphere(0, 1, -1, 1, Facing::outward), disc(1, 2, 1, -z_axis)}, 2, false);
}

Scene cylinder_wall() {
    return scene_of({wall(0, 2, 1, 1), disc(1, 0, 1, z_axis), disc(2, 2, 1, -z_axis)}, 3, true);
}

Scene cylinder_base() {
    return scene_of({disc(0, 0, 1, z_axis), wall(1, 2, 1, 1), disc(2, 2, 1, -z_axis)}, 3, true);
}

Scene sphere_caps() {
    return scene_of({sphere(0, 1, 0.5, 1, Facing::inward), sphere(1, 1, -1, -0.5, Facing::inward),
                     sphere(2, 1, -0.5, 0.5, Facing::inward)},
                    3, true);
}

Scene hemisphere() {
    return scene_of({sphere(0, 1, 0, 1, Facing::inward), disc(1, 0, 1, z_axis)}, 2, true);
}

Scene cone_wall() {
    return scene_of({wall(0, 1, 1, 0), disc(1, 0, 1, z_axis)}, 2, true);
}

Scene squares_blocked(double edge) {
    Scene scene = parallel_rectangles(1, 1, 1);
    const double low = (1 - edge) / 2;
    if (edge > 0) scene.surfaces.push_back(rectangle(no_face, {low, low, 0.5}, edge * x_axis, edge * y_axis));
    return scene;
}

Scene squares_through_aperture(double edge) {
    Scene scene = parallel_rectangles(1, 1, 1);
    const double rim = (1 - edge) / 2;
    const auto add = [&](double x, double y, double width, double height) {
        if (width > 0 && height > 0)
            scene.surfaces.push_back(rectangle(no_face, {x, y, 0.5}, width * x_axis, height * y_axis));
    };
    for (const double x : {0.0, 1 - rim}) add(x, 0, rim, 1);
    for (const double y : {0.0, 1 - rim}) add(rim, y, edge, rim);
    return scene;
}

Scene l_shaped_room(double depth) {
    const Vector3d height = 3 * z_axis;
    const double end = 1 + depth;
    return scene_of({rectangle(0, Vector3d::Zero(), height, 3 * x_axis),    // y = 0
                     rectangle(1, {0, end, 0}, x_axis, height),             // the end of the other leg
                     rectangle(2, Vector3d::Zero(), end * y_axis, height),  // x = 0
                     rectangle(3, {1, 1, 0}, height, depth * y_axis),       // x = 1, behind the corner
                     rectangle(4, {1, 1, 0}, 2 * x_axis, height),           // y = 1, behind the corner
                     rectangle(5, {3, 0, 0}, height, y_axis),               // x = 3
                     rectangle(6, Vector3d::Zero(), 3 * x_axis, y_axis),    // floor
                     rectangle(7, {0, 1, 0}, x_axis, depth * y_axis),       //
                     rectangle(8, {0, 0, 3}, y_axis, 3 * x_axis),           // ceiling
                     rectangle(9, {0, 1, 3}, depth * y_axis, x_axis)},
                    10, true);
}

Scene concentric_spheres() {
    return scene_of({sphere(0, 2, -1, 1, Facing::inward), sphere(1, 1, -1, 1, Facing::outward)}, 2, true);
}

Scene discs_blocked() {
    Scene scene = coaxial_discs(0.5, 1, 1);
    scene.surfaces.push_back(disc(no_face, 0.5, 0.25, z_axis));
    return scene;
}

Scene nested_cubes(double inner) {
    std::vector<Surface> surfaces = cube(0, 6, 1, {0, 1, 2, 3, 4, 5});
    for (Surface& surface : cube(3 - inner / 2, 3 + inner / 2, -1, {6, 7, 8, 9, 10, 11}))
        surfaces.push_back(std::move(surface));
    return scene_of(std::move(surfaces), 12, true);
}

}  // namespace ff::configuration_scenes
