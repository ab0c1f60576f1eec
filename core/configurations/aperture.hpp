#pragma once

#include "core/geometry/aligned_rectangle.hpp"

namespace ff {

/// A rectangular hole, its edges along the axes, in an opaque plane between two parallel rectangles and parallel to
/// them.
struct Aperture {
    Interval x;
    Interval y;
    long double fraction = 0.5;  ///< position in the gap, from the first rectangle, strictly between 0 and 1
};

/// What passes through an aperture from one rectangle to a parallel one that faces it, as an exchange area A_1 F_12 in
/// squared units of length. A blocker of the aperture's shape lets the rest pass. Closed form, in extended precision:
/// for a displacement (u, v) from one rectangle to the other, the rays that pass have a cross-section w_x(u) w_y(v),
/// each factor the common part of three intervals that move with u; it is piecewise linear, and the kernel's fourth
/// antiderivative, at the kinks, is an elementary function ([howell] C-13, [ehlert1993]). Within about 1e-18 of the
/// squared extent.
/// @throws UserError unless gap > 0 and 0 < fraction < 1
long double exchange_area_through_aperture(const Interval& x_from, const Interval& y_from, const Interval& x_to,
                                           const Interval& y_to, long double gap, const Aperture& aperture);

}  // namespace ff
