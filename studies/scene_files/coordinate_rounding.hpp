#pragma once

#include <span>

namespace ff::studies {

/// By how much the coordinates of a file may be off because whoever wrote it rounded them: half a unit of the last
/// decimal, or of the last significant digit, where most of them have as many and that is six digits or more; the
/// rounding of single precision where all are such numbers. 0 where they look as if they were meant so.
/// @param values  all different, none 0
double coordinate_rounding(std::span<const double> values);

}  // namespace ff::studies
