#pragma once

#include "samplers/random/random.hpp"
#include "samplers/sampler.hpp"
#include "samplers/support/fixed_text.hpp"

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace ff::samplers {

/// Fills a block with points of a sampler, each followed by its partner: points 2k and 2k + 1 are made of its point k.
/// @param partner  takes a number of a coordinate and the original's value there
template <class Sampler, class Partner>
void fill_in_pairs(const Sampler& sampler, const Stream& stream, PointIndex first, PointBlock& block, Partner partner) {
    if (block.size == 0) return;
    PointBlock originals;
    originals.dimension = block.dimension;
    originals.size = (first + block.size - 1) / 2 - first / 2 + 1;
    sampler.fill(stream, first / 2, originals);
    for (std::size_t d = 0; d < block.dimension; ++d) {
        for (std::size_t i = 0; i < block.size; ++i) {
            const std::size_t place = first % 2 + i;
            const std::uint32_t original = originals.coordinate[d][place / 2];
            block.coordinate[d][i] = place % 2 == 0 ? original : partner(d, original);
        }
    }
}

/// Any randomised equal-weight sampler in mirrored pairs: points 2k and 2k + 1 are point k of `Sampler` and its
/// reflection in the centre of the cube. @see [hammersley1956]
template <class Sampler>
class Antithetic {
    static_assert(Sampler::info.randomised && Sampler::info.equal_weights);
    static_assert(Sampler::info.sizes == Sizes::any || Sampler::info.sizes == Sizes::powers);

    static constexpr auto text_of_name = [] {
        if constexpr (std::is_same_v<Sampler, Random>) {
            return fixed("antithetic");
        } else {
            return join(fixed("antithetic_"), fixed_name<Sampler>());
        }
    }();
    static constexpr auto text_of_summary =
        join(fixed("points of `"), fixed_name<Sampler>(), fixed("`, each followed by its mirror image"));
    static constexpr auto text_of_details =
        join(fixed("Antithetic variates: points 2k and 2k + 1 are point k of `"), fixed_name<Sampler>(),
             fixed("` and its reflection in the centre of the cube, u and 1 - u. An integrand that is odd about the "
                   "centre is integrated exactly by every pair; one that is even costs twice as much as without. The "
                   "variance is at most that of half as many points of `"),
             fixed_name<Sampler>(),
             fixed("`, and the error falls at the same rate.\nSizes: twice those of the sampler it is made from; with "
                   "an odd number the last point has no partner. A single point is uniform, but the two of a pair are "
                   "not independent: take intervals over trials, never within a set."));

  public:
    static constexpr SamplerInfo info{
        .name = text_of_name.view(),
        .summary = text_of_summary.view(),
        .details = text_of_details.view(),
        .reference = "hammersley1956",
        .sizes = Sampler::info.sizes,
        .base = Sampler::info.base,
        .multiple = 2 * Sampler::info.multiple,
        .spread = Sampler::info.independent() ? Spread::mirrored : Spread::other,
    };

    explicit Antithetic(PointSetSpec spec) : sampler_((spec.points = (spec.points + 1) / 2, spec)) {}

    void fill(const Stream& stream, PointIndex first, PointBlock& block) const {
        fill_in_pairs(sampler_, stream, first, block, [](std::size_t /*d*/, std::uint32_t x) { return ~x; });
    }

  private:
    Sampler sampler_;
};

}  // namespace ff::samplers
