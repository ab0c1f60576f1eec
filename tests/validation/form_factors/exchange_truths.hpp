#pragma once

#include "core/formulas/polygon_exchange.hpp"
#include "core/geometry/scene.hpp"

namespace ff::studies {

/// Exchange areas of surfaces with nothing in between, by other ways than form factors are computed, to check those
/// with.

/// Of two polygons, by contour integrals in long double.
BoundedValue<long double> polygon_exchange(const Surface& a, const Surface& b);

/// Of a disc around the origin in z = 0 and a polygon above it: a smooth integrand, by rules that converge faster than
/// any power of their size.
double disc_exchange(const Surface& disc, const Surface& far);

/// Of a sphere and a rectangle that is in front of it, whose distance is not small beside its size: r²/d² times the
/// cosine, over the rectangle, by Gauss's rule.
double ball_exchange(const SphereZone& ball, const Surface& far);

}  // namespace ff::studies
