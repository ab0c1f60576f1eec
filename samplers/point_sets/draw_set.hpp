#pragma once

#include "samplers/point_sets/point_set.hpp"
#include "samplers/sampler.hpp"

#include <cstdint>
#include <vector>

namespace ff::samplers {

/// One point set of a sampler, outside any study.
struct DrawnSet {
    std::uint64_t points = 1024;
    std::size_t dimension = 4;
    std::uint64_t seed = 1;
    std::uint32_t trial = 0;
};

/// Draws it from a stream of its own. @throws UserError where the sampler has no such set, or its points have weights
PointSet draw_set(const CatalogueEntry& sampler, const DrawnSet& wanted);

/// All coordinates of a set, as in PointSet. @param part  points to request at a time, at most block_capacity
std::vector<std::uint32_t> coordinates_of_set(const PointSource& source, std::size_t dimension, const Stream& stream,
                                              std::size_t part = block_capacity);

}  // namespace ff::samplers
