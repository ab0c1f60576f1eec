#pragma once

#include "core/geometry/scene.hpp"

#include <Eigen/Geometry>

namespace ff {

/// Squared diagonal of the box around two polygons: errors of exchange areas are relative to it.
inline double squared_extent(const Surface& from, const Surface& to) {
    Eigen::AlignedBox3d box;
    for (const Surface* surface : {&from, &to}) {
        for (const Eigen::Vector3d& corner : corners(surface->shape)) box.extend(corner);
    }
    return box.diagonal().squaredNorm();
}

}  // namespace ff
