#pragma once

#include "core/formulas/polygon_exchange.hpp"
#include "core/geometry/fwd.hpp"

#include <optional>

namespace ff {

/// Exchange area A_1 F_12 of two polygons that are small beside their distance, in squared units of length, by Gauss's
/// rule with 8 nodes in each of four coordinates. Closed forms and contour integrals, whose errors are relative to the
/// squared extent, lose all its digits; here the error is at most 1e-11 of the product of the areas divided by the
/// squared distance. It bounds the truncation (the integrand is analytic, and its size known, where a coordinate is
/// complex and moves a place by a quarter of the distance) and estimates the rounding.
/// @return empty unless both are polygons, wholly in front of each other, and the distance of their middles is at least
/// 32 times the sum of half their edges
/// @see [trefethen2008]
std::optional<BoundedValue<double>> far_exchange_area(const Surface& from, const Surface& to);

}  // namespace ff
