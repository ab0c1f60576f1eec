#pragma once

#include "core/geometry/scene.hpp"
#include "studies/spec/spec.hpp"
#include "studies/theory/quantity.hpp"

#include <cstddef>
#include <optional>

namespace ff::studies {

/// Whether the estimates of a quantity have a variance, known from theory.
enum class VarianceStatus {
    finite,
    infinite,
    none,       ///< deterministic
    sparse,     ///< finite, but with too few hits in all trials together for t or chi-squared to hold
    undefined,  ///< some trial gave infinity or no number at all: there is no statistic
};

/// The theory of a quantity's variance. With the area kernel, a pair of faces has none when any two of its patches
/// touch such that the kernel's tail index is 2 or less (core/estimators/graded_map); a sum has none when one of its
/// terms has none.
VarianceStatus known_variance(const Method& method, const Scene& scene, Quantity quantity);

/// Whether a counted quantity has too few hits, or misses, in all trials together for Student's t to hold.
/// @param lattice  1 / rays of a trial; empty where nothing is counted
bool too_few_hits(std::optional<double> lattice, std::optional<double> reference, std::size_t trials);

}  // namespace ff::studies
