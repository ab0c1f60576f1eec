#pragma once

#include "core/formulas/polygon_exchange.hpp"
#include "core/geometry/fwd.hpp"

#include <optional>

namespace ff {

/// Exchange area A_1 F_12, in squared units of length, of a disc or an annulus and a flat surface, or of the outside of
/// a whole sphere and a flat surface. Callers have to know that nothing stands in between.
///
/// Of two flat surfaces it is the integral of ln r over both rims [sparrow1963]. A sphere that lies wholly in front of
/// a plane acts there as a source at its centre would: the exchange area is its squared radius times the solid angle
/// of the surface as seen from the centre, which is an integral along the rim, too. Integrals along circles are taken
/// by the trapezoidal rule, whose error for analytic periodic functions has a bound [trefethen2014]. Seen from a place
/// at distance d from a circle of radius R, the integrands are analytic where the imaginary part of the angle is below
/// ln(1 + d / R).
/// @param wanted  largest error that is good enough
/// @return empty for other shapes, for surfaces that are not wholly in front of each other, and where rims are so close
/// that the rule would need too many nodes; the error bounds the truncation and estimates the rounding
std::optional<BoundedValue<double>> round_exchange_area(const Surface& from, const Surface& to, double wanted);

}  // namespace ff
