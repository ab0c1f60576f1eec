#pragma once

#include <span>

namespace ff::studies {

/// By how much the coordinates of a file may be off because whoever wrote it rounded them: half a unit of the last
/// decimal, or of the last significant digit, where most of them have as many and that is six digits or more; the
/// rounding of single precision where all are such numbers. 0 where they look as if they were meant so, as decimals are
/// that owe their many digits to where the scene lies: of its size they give few.
/// @param values  all different, none 0
/// @param size    of the scene, in the same unit
double coordinate_rounding(std::span<const double> values, double size);

}  // namespace ff::studies
