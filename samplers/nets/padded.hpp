#pragma once

#include "samplers/sampler.hpp"

namespace ff::samplers {

/// Two scrambled 2-D Sobol' nets, shuffled and set side by side. @see [kollig2002], [burley2020], [vegdahl2021]
class Padded {
  public:
    static constexpr SamplerInfo info{
        .name = "padded",
        .summary = "two scrambled 2-D Sobol' nets, shuffled and set side by side, as renderers do",
        .details =
            "Padding: coordinates 0 and 1 (the place on the source) are one 2-D net, coordinates 2 and 3 (direction, "
            "or place on the target) another, both from the first two dimensions of Sobol'. Each has its own order, a "
            "nested random permutation of the index by the hash of `sobol`, and its own hash-based Owen scrambling "
            "(Burley 2020). Any 2^m points that start at a multiple of 2^m form a (0, m, 2)-net in either pair of "
            "coordinates; between the pairs there is nothing but chance.\n"
            "Sizes: powers of two; with others estimates stay unbiased and lose part of their gain. What depends on "
            "one pair alone is integrated as well as by `sobol` or better; what depends on both, as tallies of rays "
            "and area kernels do, keeps the N^-1/2 of `random`. Points of one set are not independent: take intervals "
            "over trials, never within a set.",
        .reference = "kollig2002",
        .sizes = Sizes::powers,
        .spread = Spread::padded_nets,
    };

    explicit Padded(const PointSetSpec& /*spec*/) {}
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const;
};

}  // namespace ff::samplers
