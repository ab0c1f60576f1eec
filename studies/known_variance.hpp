#pragma once

#include "core/scene.hpp"
#include "studies/spec.hpp"
#include "studies/summary.hpp"

namespace ff::studies {

/// What theory knows about the variance of a quantity. A pair of faces has none with the area kernel when any two of
/// its patches touch so that the kernel's tail index is 2 or less (core/graded_map), and a sum none when one of its
/// terms has none.
VarianceStatus known_variance(const Method& method, const Scene& scene, Quantity quantity);

}  // namespace ff::studies
