#pragma once

#include "stats/basics/resampling.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ff::stats {

/// How often each replicate is drawn in each resample of a ladder, with replacement within its rung. Drawn once and
/// shared by all statistics of the same replicates.
///
/// Above `most_blocks` replicates, blocks of consecutive ones are drawn instead: sums over independent replicates have
/// the same distribution either way, and a spread that 4096 blocks show is known to 1 %.
class LadderDraws {
  public:
    static constexpr std::size_t most_blocks = 4096;

    /// @param replicates  of each rung
    LadderDraws(std::span<const std::size_t> replicates, const ResamplingPlan& plan);

    [[nodiscard]] std::size_t resamples() const { return resamples_; }
    /// Replicates per block; the last block of a rung may have fewer.
    [[nodiscard]] std::size_t block(std::size_t rung) const { return rungs_[rung].block; }
    /// [block]: times drawn.
    [[nodiscard]] std::span<const std::uint32_t> counts(std::size_t resample, std::size_t rung) const;

  private:
    struct RungBlocks {
        std::size_t block = 1;
        std::size_t blocks = 0;
        std::size_t begin = 0;  // in the counts of a resample
    };

    std::size_t resamples_;
    std::size_t width_ = 0;  // blocks of all rungs
    std::vector<RungBlocks> rungs_;
    std::vector<std::uint32_t> counts_;
};

}  // namespace ff::stats
