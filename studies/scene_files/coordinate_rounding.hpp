#pragma once

#include <span>

namespace ff::studies {

/// How far the coordinates of a file may be off because whoever wrote it rounded them: half a unit of the last decimal,
/// or of the last significant digit, where most of them have the same number of digits, six or more; the rounding of
/// single precision where all are such numbers, or were before they were written; half a unit of the fifteenth digit
/// far away, where they have as many digits as doubles. 0 where they look exact, for example decimals that have many
/// digits only because the scene lies far away, but few in relation to its size.
/// @param values  all different, none 0
/// @param size    of the scene, in the same unit
double coordinate_rounding(std::span<const double> values, double size);

/// The unit to which coordinates may have been rounded, or else are exact, for they are so few: of the last decimal
/// that a third of them share, of the last significant digit of most, or the largest that all are multiples of. 0 where
/// that is more than a hundredth of the scene's size, or coordinate_rounding is as large. Takes the same values.
double coordinate_step(std::span<const double> values, double size);

}  // namespace ff::studies
