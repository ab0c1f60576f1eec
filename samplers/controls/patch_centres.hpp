#pragma once

#include "samplers/random/random.hpp"

#include <algorithm>

namespace ff::samplers {

/// Control: `random` with every origin in the middle of its patch.
class PatchCentres {
  public:
    static constexpr SamplerInfo info{
        .name = "patch_centres",
        .summary = "random, but every ray starts in the middle of its patch: biased",
        .details =
            "Coordinates 0 and 1 are one half, the others those of `random`: directions are right, the average over "
            "the source patch is replaced by its middle. A shortcut that is easily taken, since it looks right and is "
            "no noisier than the truth. Its bias is that of a midpoint rule and falls with the size of the patches as "
            "their area; on 13 x 13 patches of a cube's face it is far below the noise of one run.\n"
            "Caught by: a bias gate.",
        .reference = "",
        .sizes = Sizes::any,
        .control = true,
        .unbroken_name = "random",
    };

    explicit PatchCentres(const PointSetSpec& spec) : random_(spec) {}
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const {
        random_.fill(stream, first, block);
        for (std::size_t d = 0; d < 2; ++d) std::fill_n(block.coordinate[d].begin(), block.size, 0x80000000u);
    }

  private:
    Random random_;
};

}  // namespace ff::samplers
