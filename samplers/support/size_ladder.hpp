#pragma once

#include "samplers/sampler.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ff::samplers {

/// The sizes from `low` to `high` that a sampler is made for, the smallest of each octave [2^j, 2^(j+1)): powers of its
/// base for nets, k^dimension for stratified points, powers of two for samplers of any size. Empty where there is none.
/// @pre 1 <= low <= high <= max_points, info.sizes != Sizes::nodes
std::vector<std::uint64_t> size_ladder(const SamplerInfo& info, std::uint64_t low, std::uint64_t high,
                                       std::size_t dimension = max_dimension);

}  // namespace ff::samplers
