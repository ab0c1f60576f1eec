#pragma once

#include "samplers/random/random.hpp"

namespace ff::samplers {

/// Control: `random` with the same seed in every trial.
class SameSeed {
  public:
    static constexpr SamplerInfo info{
        .name = "same_seed",
        .summary = "random, but every trial is seeded alike: replicates that replicate nothing",
        .details =
            "The number of the trial does not enter the stream, so all trials give the same estimate, bit for bit. "
            "Each trial alone is right; together they have no spread, and an interval made of it would be one of width "
            "zero around a wrong value.\n"
            "Caught by: the check for repeated trials that goes before every gate.",
        .reference = "",
        .sizes = Sizes::any,
        .control = true,
        .unbroken_name = "random",
    };

    explicit SameSeed(const PointSetSpec& spec) : random_(spec) {}
    void fill(Stream stream, PointIndex first, PointBlock& block) const {
        stream.trial = 0;
        random_.fill(stream, first, block);
    }

  private:
    Random random_;
};

}  // namespace ff::samplers
