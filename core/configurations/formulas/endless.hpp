#pragma once

namespace ff {

/// Two-dimensional configurations: surfaces that are infinite and uniform in one direction.

/// Between two plates of equal width that share an edge at this angle, in radians, 0 to pi: 1 - sin(angle / 2), by
/// crossed strings. @see [howell] C-5, [hottel1954]   @throws UserError for other angles
long double wedge_factor(long double angle);

/// From a plane to one row of parallel tubes in front of it, which shade each other; `cover` is their diameter over the
/// distance of their axes, 0 to 1. @see [hottel1954]   @throws UserError for other values
long double plane_to_tubes_factor(long double cover);

}  // namespace ff
