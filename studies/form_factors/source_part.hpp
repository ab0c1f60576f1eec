#pragma once

#include "core/geometry/scene.hpp"
#include "studies/form_factors/source_cells.hpp"

#include <Eigen/Core>

#include <vector>

namespace ff::studies {

/// How large a part of a surface is, at most. Places are relative to an origin near it.
struct PartExtent {
    std::vector<Eigen::Vector3d> hull;  ///< corners of a convex set that holds the part
    Eigen::Vector3d centre;
    double radius = 0;     ///< of a ball around `centre` that holds it
    double size = 0;       ///< no two places are farther apart
    double turn = 0;       ///< nor normals
    bool s_longer = true;  ///< than in t
};

PartExtent extent_of(const Surface& source, const Eigen::Vector3d& origin, const SourceCell& cell);

struct Edge {
    Eigen::Vector3d a;
    Eigen::Vector3d b;
};

/// How much a form factor from a place in the part can change, per length that the place moves, for this edge of what
/// is seen or hidden. The edge is as long as the angle that it subtends, and moves by at most the inverse of its
/// distance per length.
double slope_of(const Surface& source, const PartExtent& part, const Edge& edge);

/// An upper bound of the form factor to something of this area.
/// @param distance  it is nowhere nearer
/// @param height    nor anywhere higher above the horizon; infinite where there is no horizon
double ball_factor(double area, double distance, double height);

}  // namespace ff::studies
