#pragma once

#include "core/geometry/fwd.hpp"

#include <Eigen/Core>

#include <optional>

namespace ff {

/// Patches with areas and exact form factors.
struct Enclosure {
    Eigen::MatrixXd factors;
    Eigen::VectorXd areas;
};

/// A concave surface (0) and the flat or convex one (1) that closes it or lies inside it: F_01 = A_1 / A_0, and the
/// remainder is its self-view. A hemisphere and its base, a cone and its base, a sphere in a sphere. @pre 0 < opening
/// <= area
Enclosure cavity(double area, double opening);

/// A cylinder from inside: base (0), top (1) and the wall (2), which sees itself. @see [howell] C-41
Enclosure closed_cylinder(double radius, double height);

/// The inside of a box one face of which is a perfect mirror: extended form factors between the other faces, straight
/// or by way of the mirror, so that a face opposite it sees itself. The mirror is not a face; the others keep their
/// order. @see [baranoski1999] section 2.2, [sillion1989]
/// @return empty unless the scene is an empty box @pre a face of it
std::optional<Enclosure> box_with_mirror(const Scene& box, int mirror);

}  // namespace ff
