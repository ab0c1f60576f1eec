#pragma once

#include "core/geometry/scene.hpp"

#include <Eigen/Geometry>

#include <vector>

namespace ff::test {

/// A parallelogram that belongs to no face and radiates to the side of u x v.
inline Surface wall_at(const Eigen::Vector3d& corner, const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
    return {Parallelogram{corner, u, v}, u.cross(v).normalized(), no_face};
}

/// The unit cube, radiating outwards: floor, roof, and the four walls.
inline std::vector<Surface> unit_cube() {
    const Eigen::Vector3d x(1, 0, 0);
    const Eigen::Vector3d y(0, 1, 0);
    const Eigen::Vector3d z(0, 0, 1);
    const Eigen::Vector3d o = Eigen::Vector3d::Zero();
    return {wall_at(o, y, x), wall_at(z, x, y), wall_at(o, z, y), wall_at(x, y, z), wall_at(o, x, z), wall_at(y, z, x)};
}

}  // namespace ff::test
