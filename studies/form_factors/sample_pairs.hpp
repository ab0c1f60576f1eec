#pragma once

#include "studies/form_factors/face_pairs.hpp"
#include "studies/form_factors/sampled_row.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace ff::studies::form_factors {

struct SamplingOutcome {
    std::uint64_t samples = 0;
    std::uint64_t rays = 0;
    std::uint64_t lost = 0;
    /// Rays of each face that met nothing, and all its rays.
    std::vector<std::pair<std::uint64_t, std::uint64_t>> lost_of_rows;
    bool interrupted = false;
    std::size_t left_out = 0;  ///< rows to sample that are neither of this shard nor were received
};

/// Samples what geometry leaves open, row by row (studies/form_factors/rounds.hpp); rows that were sampled before, or
/// are by others, are taken as they are.
/// @param alpha  1 - level of a pair's interval
/// @param take   is given the estimate of each pair, by place in FacePairs::pairs, in an order that may differ from one
///               process or call to another
/// @throws UserError where a row is of another matrix
SamplingOutcome sample_pairs(const Scene& scene, const FacePairs& geometry, const Request& request, double alpha,
                             const std::function<void(std::size_t, const PairEstimate&)>& take);

}  // namespace ff::studies::form_factors
