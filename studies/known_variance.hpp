#pragma once

#include "core/scene.hpp"
#include "studies/spec.hpp"
#include "studies/summary.hpp"

#include <cstddef>
#include <optional>

namespace ff::studies {

/// What theory knows about the variance of a quantity. A pair of faces has none with the area kernel when any two of
/// its patches touch so that the kernel's tail index is 2 or less (core/graded_map), and a sum none when one of its
/// terms has none.
VarianceStatus known_variance(const Method& method, const Scene& scene, Quantity quantity);

/// Whether a counted quantity has too few hits, or misses, in all trials together for Student's t to hold.
/// @param lattice  1 / rays of a trial; empty where nothing is counted
bool too_few_hits(std::optional<double> lattice, std::optional<double> reference, std::size_t trials);

}  // namespace ff::studies
