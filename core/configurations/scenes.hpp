#pragma once

#include "core/geometry/fwd.hpp"

namespace ff {

/// The configurations of the catalogue as scenes: the two surfaces are faces "1" and "2", others that close the scene
/// are faces of their own, and obstacles belong to no face. Where a surface sees itself, the scene is closed and its
/// other faces are congruent, so that their form factors are known as well. Lengths as in
/// core/configurations/catalogue.hpp. `name` and `canonical` are the caller's to set.
namespace configuration_scenes {

Scene parallel_rectangles(double x, double y, double gap);
/// Rectangles edge x from and edge x to that share the edge, at this angle in degrees.
Scene rectangles_at_angle(double edge, double from, double to, double degrees);
Scene tetrahedron();
Scene parallel_right_triangles();
Scene coaxial_discs(double r1, double r2, double distance);
Scene sphere_to_disc();
/// Face 1: the wall; faces 2 and 3: the bases.
Scene cylinder_wall();
/// Face 1: a base; face 2: the wall; face 3: the other base.
Scene cylinder_base();
/// Faces 1 and 2: the caps; face 3: the rest of the sphere.
Scene sphere_caps();
/// Face 1: the hemisphere; face 2: the disc that closes it.
Scene hemisphere();
/// Face 1: the wall; face 2: the base.
Scene cone_wall();
/// Opposite unit squares 1 apart, halfway between them a square with this edge, 0 (none) to 1.
Scene squares_blocked(double edge);
/// The same with a unit square as obstacle that has a square hole of this edge, 0 (no hole) to 1 (no plate).
Scene squares_through_aperture(double edge);
/// Legs 1 wide, 3 high; face 1: the wall of length 3; face 2: the end of the other leg, `depth` behind the corner.
/// Faces 3 to 10: the other walls, floor and ceiling, each in rectangles.
Scene l_shaped_room(double depth);
/// Face 1: the outer sphere; face 2: the inner one.
Scene concentric_spheres();
Scene discs_blocked();
/// A cube of 6 and one with this edge, above 0 and below 6, in its middle. Faces 1 and 2 are adjacent, 3 is opposite 1,
/// 4 to 6 the other faces of the outer cube, 7 to 12 the inner cube.
Scene nested_cubes(double inner);

}  // namespace configuration_scenes

}  // namespace ff
