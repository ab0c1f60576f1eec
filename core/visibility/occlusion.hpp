#pragma once

#include "core/geometry/scene.hpp"

#include <Eigen/Core>

#include <vector>

namespace ff {

/// Whether a third surface is shown to stand nowhere between two: it lies behind one of them, its plane has both on one
/// side, or a plane across a coordinate axis or one of the normals parts it from both.
bool keeps_clear(const Surface& surface, const Surface& from, const Surface& to);

/// What may stand between two surfaces: those that are not shown to keep clear. Of the two themselves a hollow one may
/// stand in its own way. Conservative: of two convex faces that
/// see all of each other the list is empty, and tracing nothing is right.
std::vector<const Surface*> possible_blockers(const Scene& scene, const Surface& from, const Surface& to);

/// Whether something may stand between any two surfaces that face each other. Takes the cube of their number; true
/// without looking where there are more than 512.
bool may_be_occluded(const Scene& scene);

/// Whether something may stand between a surface of one face and one of the other that face each other; true without
/// looking in a scene of more than 512 surfaces. Faces from 0.
bool may_be_occluded(const Scene& scene, int from_face, int to_face);

/// Whether nothing of `blockers` lies between a place on `from` and one on `to` that each lie in front of the other. In
/// double precision, and the same on every CPU.
bool sees(const Eigen::Vector3d& place, const Surface& from, const Eigen::Vector3d& other, const Surface& to,
          const std::vector<const Surface*>& blockers);

}  // namespace ff
