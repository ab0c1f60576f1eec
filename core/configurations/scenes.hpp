#pragma once

#include "core/scene.hpp"

namespace ff {

/// The configurations of the catalogue as scenes: the two surfaces are faces "1" and "2", others that close the scene
/// are faces of their own, and what only stands in the way is no face. Where a surface sees itself, the scene is closed
/// and its other faces are alike, so that what each of them gets is known as well. Lengths as in
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
Scene squares_blocked();
Scene squares_through_aperture();
/// Faces 3 to 10: the other walls, floor and ceiling, each in rectangles.
Scene l_shaped_room();
/// Face 1: the outer sphere; face 2: the inner one.
Scene concentric_spheres();
Scene discs_blocked();
/// Faces 1 and 2 are adjacent, 3 is opposite 1, 4 to 6 the other faces of the outer cube, 7 to 12 the inner cube.
Scene nested_cubes();

}  // namespace configuration_scenes

}  // namespace ff
