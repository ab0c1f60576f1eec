#pragma once

#include "core/formulas/edge_integral.hpp"
#include "core/geometry/scene.hpp"

#include <vector>

namespace ff {

/// The corners of a plane polygon, counter-clockwise as seen from the side that it radiates to.
template <class Real>
using Corners = std::vector<Vector3<Real>>;

/// The corners of a surface. @pre a parallelogram or a triangle
template <class Real>
Corners<Real> corners_of(const Surface& surface);

/// Exchange area A_1 F_12 of two plane polygons in any relative position, in squared units of length, by the contour
/// integral: 1 / (2 pi) times the integral of ln r over both rims. Only the parts in front of each other count. Callers
/// have to know that nothing stands in between. They may touch, share edges, and have holes or bays (a rim that runs
/// along a bridge there and back).
///
/// `error` bounds the truncation and estimates the rounding; it is relative to the squared extent of the pair, not to
/// the result: about 1e-15 of it in double, 1e-18 in long double, more where edges are nearly parallel
/// (core/formulas/edge_integral.hpp). Neither value nor error is negative.
/// @see [sparrow1963], [schroeder1993]   @pre each polygon is plane, with at least three corners that span an area
template <class Real>
BoundedValue<Real> polygon_exchange_area(Corners<Real> from, Corners<Real> to);

}  // namespace ff
