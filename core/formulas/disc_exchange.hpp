#pragma once

#include "core/formulas/polygon_exchange.hpp"
#include "core/geometry/fwd.hpp"

#include <optional>

namespace ff {

/// Exchange area A_1 F_12, in squared units of length, of a disc or an annulus and a flat surface: 1 / (2 pi) times the
/// integral of ln r over both rims [sparrow1963] (core/formulas/circle_rule.hpp). Callers have to know that nothing
/// stands in between.
/// @param wanted  largest error that is good enough
/// @return empty for other shapes, for surfaces that are not wholly in front of each other, and where rims are so close
/// that the rule would need too many nodes; the error bounds the truncation and estimates the rounding
std::optional<BoundedValue<double>> disc_exchange_area(const Surface& from, const Surface& to, double wanted);

}  // namespace ff
