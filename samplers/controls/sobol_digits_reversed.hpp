#pragma once

#include "samplers/nets/sobol.hpp"
#include "samplers/support/owen_hash.hpp"

namespace ff::samplers {

/// Control: `sobol` without its last bit reversal. @see [laine2011]
class SobolDigitsReversed {
  public:
    static constexpr SamplerInfo info{
        .name = "sobol_digits_reversed",
        .summary = "sobol with its base-2 digits left in reverse order: as noisy as random",
        .details =
            "Hash-based scrambling works on reversed digits (Laine and Karras 2011) and has to reverse them twice; "
            "here the second time is forgotten. What was arranged in the high digits of the points lies in the low "
            "ones, where no integrand sees it. Every point is still uniform, so nothing is biased, but the net is "
            "gone and with it the gain over `random`.\n"
            "Caught by: a gate on the standard deviation, or on the slope.",
        .reference = "laine2011",
        .sizes = Sizes::powers,
        .control = true,
        .unbroken_name = "sobol",
    };

    explicit SobolDigitsReversed(const PointSetSpec& spec) : sobol_(spec) {}
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const {
        sobol_.fill(stream, first, block);
        for (std::size_t d = 0; d < block.dimension; ++d) {
            for (std::size_t i = 0; i < block.size; ++i) block.coordinate[d][i] = reverse_bits(block.coordinate[d][i]);
        }
    }

  private:
    Sobol sobol_;
};

}  // namespace ff::samplers
