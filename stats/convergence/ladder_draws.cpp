#include "stats/convergence/ladder_draws.hpp"

#include <algorithm>

namespace ff::stats {

LadderDraws::LadderDraws(std::span<const std::size_t> replicates, const ResamplingPlan& plan)
    : resamples_(plan.replicates) {
    for (const std::size_t n : replicates) {
        const std::size_t block = std::max<std::size_t>(1, (n + most_blocks - 1) / most_blocks);
        const std::size_t blocks = (n + block - 1) / block;
        rungs_.push_back({.block = block, .blocks = blocks, .begin = width_});
        width_ += blocks;
    }
    counts_.assign(resamples_ * width_, 0);
    for (std::uint32_t resample = 0; resample < plan.replicates; ++resample) {
        Draws draws(plan.key, Resampling::bootstrap, resample);
        for (const RungBlocks& rung : rungs_) {
            const std::span<std::uint32_t> counts(counts_.data() + resample * width_ + rung.begin, rung.blocks);
            for (std::size_t n = 0; n < rung.blocks; ++n) ++counts[draws.below(rung.blocks)];
        }
    }
}

std::span<const std::uint32_t> LadderDraws::counts(std::size_t resample, std::size_t rung) const {
    return {counts_.data() + resample * width_ + rungs_[rung].begin, rungs_[rung].blocks};
}

}  // namespace ff::stats
