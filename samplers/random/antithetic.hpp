#pragma once

#include "samplers/random/random.hpp"
#include "samplers/sampler.hpp"
#include "samplers/support/fixed_text.hpp"

#include <cstddef>
#include <type_traits>

namespace ff::samplers {

/// Writes points and their mirror images in turn: point i of `originals` becomes point 2 i, if `skip` is 0.
/// @param skip  1 where the first point of `block` is a mirror image
void mirror_points(const PointBlock& originals, std::size_t skip, PointBlock& block);

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
        if (block.size == 0) return;
        PointBlock originals;
        originals.dimension = block.dimension;
        originals.size = (first + block.size - 1) / 2 - first / 2 + 1;
        sampler_.fill(stream, first / 2, originals);
        mirror_points(originals, first % 2, block);
    }

  private:
    Sampler sampler_;
};

}  // namespace ff::samplers
