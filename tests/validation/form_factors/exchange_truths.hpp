#pragma once

#include "core/formulas/polygon_exchange.hpp"
#include "core/geometry/scene.hpp"

namespace ff::studies::form_factors {

/// Exchange areas of surfaces with nothing in between, computed in other ways than form factors are, to check those.

/// Exchange area of two polygons, by contour integrals in long double.
BoundedValue<long double> polygon_exchange(const Surface& a, const Surface& b);

/// Exchange area of a disc around the origin in z = 0 and a polygon above it. The integrand is smooth: the rules
/// converge faster than any power of their size.
double disc_exchange(const Surface& disc, const Surface& far);

/// Exchange area of a sphere and a rectangle that is in front of it, at a distance that is not small beside its size:
/// the integral of r²/d² times the cosine over the rectangle, by Gauss's rule.
double ball_exchange(const SphereZone& ball, const Surface& far);

}  // namespace ff::studies::form_factors
