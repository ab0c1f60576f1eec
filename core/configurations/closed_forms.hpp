#pragma once

#include "core/formulas/rectangle_formulas.hpp"

namespace ff {

/// Form factors of configurations in extended precision: dimensionless, lengths in one unit. All throw UserError for
/// lengths that are not positive and finite.

/// Plane polygons, by contour integrals (core/formulas/polygon_exchange.hpp), within about 1e-17.

/// Between two rectangles that share a whole edge: `from` and `to` are their widths across it, the angle between them
/// is in radians, strictly between 0 and pi. @see [howell] C-16   @throws UserError for other values
long double rectangles_at_angle_factor(long double edge, long double from, long double to, long double angle);

/// Between the right triangles (0,1,1) (1,1,1) (1,0,1) and (1,0,0) (1,1,0) (0,1,0): the same half of two opposite faces
/// of a unit cube.
long double parallel_right_triangles_factor();

/// Between two faces of a regular tetrahedron; by symmetry and closure 1/3.
long double tetrahedron_factor();

/// From an element of area to a parallel rectangle a x b at a distance, one corner of which lies on the element's
/// normal. @see [howell] B-4
long double element_to_rectangle_factor(long double a, long double b, long double distance);

/// Discs on a common axis, in planes at right angles to it, facing each other: accurate to a few units in the last
/// place of a long double.

/// From the disc of radius r1 to the disc of radius r2, `distance` apart. @see [howell] C-41
long double coaxial_discs_factor(long double r1, long double r2, long double distance);

/// From an element of area at the foot of the axis, parallel to the disc. @see [howell] B-12
long double element_to_disc_factor(long double radius, long double distance);

/// A disc that stands between the two, on the same axis.
struct DiscBlocker {
    long double radius = 0;
    long double distance = 0;  ///< distance from the first disc
};

/// From the disc of radius r1 to the one of radius r2 past an opaque disc, where the blocker's whole shadow falls on
/// the second disc: the result is then F12 - F1b, since exactly what reaches the blocker is lost.
/// @throws UserError also where the blocker's shadow reaches beyond the second disc
long double blocked_coaxial_discs_factor(long double r1, long double r2, long double distance, DiscBlocker blocker);

/// From a sphere to a disc whose axis passes through the sphere's centre, `distance` from the disc. The sphere may have
/// any radius that keeps it on its side of the disc: a sphere radiates like a point, so this is the disc's share of all
/// directions from the centre. @see [howell]
long double sphere_to_disc_factor(long double disc_radius, long double distance);

/// Inside a sphere, from any part of it (the cap included) to a cap of this height: every part receives its share of
/// the total area, h / 2R. A hemisphere is a cap of height R. @see [howell]
/// @throws UserError where the cap is higher than the sphere
long double sphere_cap_factor(long double sphere_radius, long double cap_height);

/// From the inside of the outer of two concentric spheres to itself, past the opaque inner one.
/// By reciprocity and closure: 1 - (inner / outer)^2. @throws UserError unless inner < outer
long double outer_sphere_to_itself_factor(long double inner_radius, long double outer_radius);

/// From the wall of a right circular cylinder to itself, inside: 1 + H - sqrt(1 + H^2) with H = height / 2 radius. @see
/// [howell]
long double cylinder_wall_to_itself_factor(long double radius, long double height);

/// From a base of a cylinder to its wall: by reciprocity and closure 2 H / (H + sqrt(1 + H^2)), H as above. The
/// remainder reaches the other base (`coaxial_discs_factor`). @see [howell]
long double cylinder_base_to_wall_factor(long double radius, long double height);

/// From the wall of a right circular cone to itself, inside: all that leaves its base reaches the wall, the rest
/// follows by reciprocity and closure, 1 - radius / slant height. @see [howell]
long double cone_wall_to_itself_factor(long double radius, long double height);

/// From the inside of a cylinder to the outside of a smaller one, coaxial and as high. @see [howell]
/// @throws UserError unless inner < outer
long double outer_cylinder_to_inner_factor(long double inner, long double outer, long double height);

/// From the inside of a cylinder to itself, past the opaque smaller one. @see [howell]
/// @throws UserError unless inner < outer
long double outer_cylinder_to_itself_factor(long double inner, long double outer, long double height);

/// Two-dimensional configurations: surfaces that are infinite and uniform in one direction.

/// Between two plates of equal width that share an edge at this angle, in radians, 0 to pi: 1 - sin(angle / 2), by
/// crossed strings. @see [howell] C-5, [hottel1954]   @throws UserError for other angles
long double wedge_factor(long double angle);

/// From a plane to one row of parallel tubes in front of it, which shade each other; `cover` is their diameter over the
/// distance of their axes, 0 to 1. @see [hottel1954]   @throws UserError for other values
long double plane_to_tubes_factor(long double cover);

/// A rectangular hole, its edges along the axes, in an opaque plane between two parallel rectangles and parallel to
/// them.
struct Aperture {
    AxisInterval x;
    AxisInterval y;
    long double fraction = 0.5;  ///< position in the gap, from the first rectangle, strictly between 0 and 1
};

/// Exchange area A_1 F_12 through an aperture, from one rectangle to a parallel one that faces it, in
/// squared units of length. A blocker of the aperture's shape lets the rest pass. Closed form, in extended precision:
/// for a displacement (u, v) from one rectangle to the other, the rays that pass have a cross-section w_x(u) w_y(v),
/// each factor the common part of three intervals that move with u; it is piecewise linear, and the kernel's fourth
/// antiderivative, at the kinks, is an elementary function ([howell] C-13, [ehlert1993]). Within about 1e-18 of the
/// squared extent.
/// @throws UserError unless gap > 0 and 0 < fraction < 1
long double exchange_area_through_aperture(const AxisInterval& x_from, const AxisInterval& y_from,
                                           const AxisInterval& x_to, const AxisInterval& y_to, long double gap,
                                           const Aperture& aperture);

/// The same as a factor, between opposite unit squares 1 apart, through a square hole of this edge, 0 to 1, in the
/// middle of a plate halfway between them.
long double squares_through_aperture_factor(long double edge);

/// Between the same squares, past a square of this edge in place of the hole.
long double squares_blocked_factor(long double edge);

/// From the wall of 3 x 3 of an L-shaped room to the end of 1 x 3 of the other leg, which is `depth` behind the corner.
/// The mouth of the leg is the aperture.
long double l_shaped_room_exchange_area(long double depth);

/// A cube in the middle of a larger one, edges parallel: factors between faces of the larger one, seen past the opaque
/// smaller one. Dimensionless, within 1e-17; edges in one unit.
/// Both throw UserError unless 0 < inner < outer.

/// Between opposite faces. For a displacement (u, v), the inner cube blocks a hexagon: the box around the shadows of
/// its two faces without two triangular corners. The box has a closed form (the same as an aperture's); the corners,
/// smooth in four pieces, are integrated by Gauss's rule with 30 x 30 nodes each.
long double nested_cubes_opposite_factor(long double inner, long double outer);

/// Between adjacent faces: by closure, since a face of the outer cube sends (inner / outer)^2 to the inner one, by
/// reciprocity.
long double nested_cubes_adjacent_factor(long double inner, long double outer);

}  // namespace ff
