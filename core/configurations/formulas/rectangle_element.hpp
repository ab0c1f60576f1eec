#pragma once

namespace ff {

/// From an element of area to a parallel rectangle a x b at a distance, one corner of which lies on the element's
/// normal. Dimensionless; lengths in one unit. @see [howell] B-4
/// @throws UserError for lengths that are not positive and finite
long double element_to_rectangle_factor(long double a, long double b, long double distance);

}  // namespace ff
