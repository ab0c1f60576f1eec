#pragma once

#include "core/points/points.hpp"

namespace ff::samplers {

/// Fills coordinate d of point i with word d of philox(stream, first + i, purpose), several points at a time.
void philox_block(const Stream& stream, Purpose purpose, PointIndex first, PointBlock& block);

}  // namespace ff::samplers
