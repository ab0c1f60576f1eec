#pragma once

#include "core/geometry/scene.hpp"

#include <Eigen/Core>

#include <vector>

namespace ff {

/// A circle at which a curved surface ends, and the direction from there along the surface's axis, of unit length.
struct RoundEnd {
    Eigen::Vector3d centre;
    double radius = 0;
    Eigen::Vector3d inwards;
};

/// The ends of a frustum or a zone of a sphere, none where it ends in a point; none of a flat shape.
std::vector<RoundEnd> round_ends(const Shape& shape);

}  // namespace ff
