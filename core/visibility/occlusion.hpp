#pragma once

#include "core/geometry/fwd.hpp"
#include "core/visibility/facing.hpp"

#include <Eigen/Core>

#include <vector>

namespace ff {

/// Whether a third surface is proved not to stand between two: it lies behind one of them, its plane has both on one
/// side, or a plane across a coordinate axis or one of the normals separates it from both.
/// @param room  it may reach across by this share of the pair's length
bool keeps_clear(const Surface& surface, const Surface& from, const Surface& to, double room = rounding_room);

/// The surfaces that may stand between two: those not shown to keep clear. A concave one of the two may itself be
/// among them. Conservative: for two convex faces that see all of each other the list is empty, and nothing has to be
/// traced.
std::vector<const Surface*> possible_blockers(const Scene& scene, const Surface& from, const Surface& to);

/// Whether something may stand between any two surfaces that face each other. The cost is cubic in their number; true
/// without a test where there are more than 512.
bool may_be_occluded(const Scene& scene);

/// Whether something may stand between a surface of one face and one of the other that face each other; true without a
/// test in a scene of more than 512 surfaces. Faces from 0.
bool may_be_occluded(const Scene& scene, int from_face, int to_face);

/// Whether places of one face may see another only in part, or not at all: something may stand between, or parts lie
/// behind the other's plane. Faces from 0.
bool may_be_seen_in_part(const Scene& scene, int from_face, int to_face);

/// Whether nothing of `blockers` lies between a place on `from` and one on `to` that each lie in front of the other. In
/// double precision, and the same on every CPU.
bool sees(const Eigen::Vector3d& place, const Surface& from, const Eigen::Vector3d& other, const Surface& to,
          const std::vector<const Surface*>& blockers);

}  // namespace ff
