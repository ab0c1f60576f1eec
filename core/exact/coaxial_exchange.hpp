#pragma once

#include "core/formulas/polygon_exchange.hpp"
#include "core/geometry/fwd.hpp"
#include "core/visibility/facing.hpp"

#include <optional>
#include <span>

namespace ff {

/// Exchange area A_1 F_12, in squared units of length, of two surfaces about one axis (discs, annuli, insides of
/// cylinders, cones and spheres) that see each other wholly, or of one of them with itself: such as any two parts of a
/// can. Like that of flat surfaces it depends on the rims alone: it is a sum of exchange areas of the discs that they
/// enclose [howell] C-41, and of the area where a surface meets itself.
/// @param between  what may stand in between
/// @return empty for other surfaces, and unless all of that is shown to keep clear
std::optional<BoundedValue<double>> coaxial_exchange_area(const Surface& from, const Surface& to,
                                                          std::span<const Blocker> between);

}  // namespace ff
