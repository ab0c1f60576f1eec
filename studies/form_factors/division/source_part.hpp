#pragma once

#include "core/geometry/scene.hpp"
#include "core/geometry/surface_map.hpp"
#include "studies/form_factors/division/source_cells.hpp"

#include <Eigen/Core>

#include <vector>

namespace ff::studies::form_factors {

/// Bounds of a part of a surface. Places are relative to an origin near it.
struct PartExtent {
    std::vector<Eigen::Vector3d> hull;  ///< corners of a convex set that holds the part
    Eigen::Vector3d centre;
    double radius = 0;     ///< the ball of this radius around `centre` holds the part
    double size = 0;       ///< largest distance of two places
    double turn = 0;       ///< largest difference of two unit normals
    bool s_longer = true;  ///< the part is longer in s than in t
};

/// @param map  of the source
PartExtent extent_of(const Surface& source, const SurfaceMap& map, const Eigen::Vector3d& origin,
                     const SourceRange& range);

/// An upper bound of the form factor to something of this area.
/// @param distance  its smallest distance
/// @param height    its largest height above the horizon; infinite without a horizon
double ball_factor(double area, double distance, double height);

}  // namespace ff::studies::form_factors
