#pragma once

#include "core/geometry/fwd.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/visibility/facing.hpp"

#include <Eigen/Geometry>

#include <array>
#include <optional>
#include <vector>

namespace ff {

/// The straight lines from one surface to another, for tests of many others against them.
class LinesBetween {
  public:
    /// References are kept.
    LinesBetween(const Surface& from, const Surface& to);

    /// Whether a third surface is proved not to stand between the two: it lies behind one of them, its plane has both
    /// on one side, or a plane across a coordinate axis or one of the normals separates it from both. It may reach
    /// across by `rounding_room` of their own length, however large it is itself.
    [[nodiscard]] bool keep_clear_of(const Surface& surface) const;

  private:
    const Surface& from_;
    const Surface& to_;
    Eigen::AlignedBox3d box_;
    /// One of the two, if it is flat.
    struct Front {
        Eigen::Vector3d normal;
        double plane = 0;  ///< height of the surface
        Extent both;       ///< heights of both
    };
    std::array<std::optional<Front>, 2> fronts_;  ///< of either

    [[nodiscard]] Extent along(const Eigen::Vector3d& direction) const;
};

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
