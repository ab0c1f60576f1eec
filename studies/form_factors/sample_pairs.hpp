#pragma once

#include "studies/form_factors/face_pairs.hpp"
#include "studies/form_factors/sampled_row.hpp"

#include <cstdint>
#include <vector>

namespace ff::studies::form_factors {

/// Estimates of the pairs that are sampled; most are not, and take no room.
class PairEstimates {
  public:
    explicit PairEstimates(const FacePairs& geometry);

    /// @param pair  place in FacePairs::pairs; all pairs that are not sampled share one without an estimate
    [[nodiscard]] const PairEstimate& operator[](std::size_t pair) const { return estimates_[places_[pair]]; }
    /// @pre the pair is sampled
    [[nodiscard]] PairEstimate& operator[](std::size_t pair) { return estimates_[places_[pair]]; }

  private:
    std::vector<std::uint32_t> places_;
    std::vector<PairEstimate> estimates_;
};

struct SamplingOutcome {
    PairEstimates estimates;
    std::uint64_t samples = 0;
    std::uint64_t rays = 0;
    std::uint64_t lost = 0;
    bool interrupted = false;
    std::size_t left_out = 0;  ///< rows to sample that are neither of this shard nor were received
};

/// Samples what geometry leaves open, row by row (studies/form_factors/rounds.hpp); rows that were sampled before, or
/// are by others, are taken as they are.
/// @param alpha  1 - level of a pair's interval
/// @throws UserError where a row is of another matrix
SamplingOutcome sample_pairs(const Scene& scene, const FacePairs& geometry, const Request& request, double alpha,
                             bool rays_are_exact_enough);

}  // namespace ff::studies::form_factors
