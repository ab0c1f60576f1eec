#pragma once

#include "core/formulas/rectangle_formulas.hpp"

namespace ff {

/// A rectangular hole, its edges along the axes, in an opaque plane between two parallel rectangles and parallel to
/// them.
struct Aperture {
    AxisInterval x;
    AxisInterval y;
    long double fraction = 0.5;  ///< position in the gap, from the first rectangle, strictly between 0 and 1
};

/// What passes through an aperture from one rectangle to a parallel one that faces it, as an exchange area A_1 F_12 in
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
