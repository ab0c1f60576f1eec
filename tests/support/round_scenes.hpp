#pragma once

#include "core/geometry/scene.hpp"

#include <Eigen/Core>

#include <cmath>
#include <string>
#include <vector>

namespace ff::test {

/// A tilted axis, so that nothing is right by accident of symmetry.
inline const Eigen::Vector3d tilted = Eigen::Vector3d(0.36, 0.48, 0.8);

inline Surface disc(const Eigen::Vector3d& centre, const Eigen::Vector3d& normal, double radius, double inner = 0) {
    return {Disc{centre, inner, radius}, normal, 0};
}
inline Surface wall(const Eigen::Vector3d& base, const Eigen::Vector3d& axis, double base_radius, double top_radius,
                    Facing facing) {
    return {Frustum{base, axis, base_radius, top_radius, facing}, Eigen::Vector3d::Zero(), 0};
}
inline Surface sphere(const Eigen::Vector3d& centre, double radius, Facing facing, double low = -1, double high = 1) {
    return {SphereZone{centre, tilted, radius, low, high, facing}, Eigen::Vector3d::Zero(), 0};
}

/// A scene in which each surface is a face, in order.
inline Scene faces_of(std::vector<Surface> surfaces, bool closed) {
    Scene scene;
    scene.closed = closed;
    for (Surface& surface : surfaces) {
        surface.face = static_cast<int>(scene.faces.size());
        scene.faces.push_back(std::to_string(scene.faces.size() + 1));
        scene.surfaces.push_back(surface);
    }
    return scene;
}

inline const Eigen::Vector3d somewhere = Eigen::Vector3d(0.3, -0.2, 0.1);

inline Scene hollow_sphere() {
    return faces_of({sphere(somewhere, 1.7, Facing::inward)}, true);
}
/// Radius 1, height 3: base, top and wall.
inline Scene closed_can() {
    const Eigen::Vector3d top = somewhere + 3 * tilted;
    return faces_of(
        {disc(somewhere, tilted, 1), disc(top, -tilted, 1), wall(somewhere, 3 * tilted, 1, 1, Facing::inward)}, true);
}
/// Radius 1, height 2: base and wall.
inline Scene closed_cone() {
    return faces_of({disc(somewhere, tilted, 1), wall(somewhere, 2 * tilted, 1, 0, Facing::inward)}, true);
}
/// Radii 0.6 inside of 1.5.
inline Scene concentric_spheres() {
    return faces_of({sphere(somewhere, 0.6, Facing::outward), sphere(somewhere, 1.5, Facing::inward)}, true);
}
/// A frustum, radii 1 and 0.5, closed by a disc and a cap.
inline Scene domed_frustum() {
    const Eigen::Vector3d top = somewhere + tilted;
    // A cap of the sphere around top - 0.5 tilted, of which it cuts off a ring of radius 0.5.
    const double radius = 0.5 * std::sqrt(2.0);
    return faces_of({disc(somewhere, tilted, 1), wall(somewhere, tilted, 1, 0.5, Facing::inward),
                     sphere(top - 0.5 * tilted, radius, Facing::inward, 0.5 / radius, 1)},
                    true);
}
/// An annulus, a sleeve inside of a can.
inline Scene sleeve() {
    const Eigen::Vector3d top = somewhere + 2 * tilted;
    return faces_of(
        {disc(somewhere, tilted, 1, 0.4), disc(top, -tilted, 1, 0.4), wall(somewhere, 2 * tilted, 1, 1, Facing::inward),
         wall(somewhere, 2 * tilted, 0.4, 0.4, Facing::outward)},
        true);
}

}  // namespace ff::test
