#pragma once

#include "samplers/nets/sobol.hpp"
#include "samplers/sampler.hpp"
#include "samplers/support/fixed_text.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace ff::samplers {

/// Rays from one sampled place in one set of directions.
inline constexpr std::uint64_t local_directions = 12;

/// Sets of directions from sampled places: each origin, a Sobol' point, has a set of `Sampler` by itself. @see
/// [jacques2015]
template <class Sampler>
class LocalDirections {
    static_assert(Sampler::info.randomised && Sampler::info.equal_weights && Sampler::info.sizes == Sizes::any);

    static constexpr auto text_of_name = join(fixed_name<Sampler>(), fixed("_local"));
    static constexpr auto text_of_summary =
        join(fixed("Sobol' points as origins, each with 12 directions that are a set of `"), fixed_name<Sampler>(),
             fixed("`"));
    static constexpr auto text_of_details =
        join(fixed("Points 12 k to 12 k + 11 share one origin, a point of `sobol` in the coordinates before the last "
                   "two; these, the direction, are a set of `"),
             fixed_name<Sampler>(),
             fixed("` in two dimensions, drawn anew for each origin. Places are fewer than with one ray from each: to "
                   "prefer where they hardly differ in what they see.\nAny number of points; the last origin has what "
                   "is left. Points are not independent: take intervals over trials, never within a set."));

  public:
    static constexpr SamplerInfo info{
        .name = text_of_name.view(),
        .summary = text_of_summary.view(),
        .details = text_of_details.view(),
        .reference = "jacques2015",
        .sizes = Sizes::any,
        .nanoseconds = Sampler::info.nanoseconds,
    };

    explicit LocalDirections(const PointSetSpec& spec)
        : origins_(spec), directions_({.points = std::min(spec.points, local_directions), .dimension = 2}) {}

    void fill(const Stream& stream, PointIndex first, PointBlock& block) const {
        if (block.dimension < 2) return origins_.fill(stream, first, block);
        PointBlock part;
        std::size_t done = 0;
        while (done < block.size) {
            const std::uint64_t place = (first + done) / local_directions;
            const std::uint64_t begin = (first + done) % local_directions;
            const std::size_t count = std::min<std::size_t>(block.size - done, local_directions - begin);
            part.dimension = block.dimension;
            part.size = 1;
            origins_.fill(stream, place, part);
            for (std::size_t d = 0; d + 2 < block.dimension; ++d)
                std::fill_n(block.coordinate[d].begin() + done, count, part.coordinate[d][0]);
            part.dimension = 2;
            part.size = count;
            directions_.fill(stream_of_place(stream, place), begin, part);
            for (std::size_t d = 0; d < 2; ++d)
                std::copy_n(part.coordinate[d].begin(), count,
                            block.coordinate[block.dimension - 2 + d].begin() + done);
            done += count;
        }
    }

  private:
    /// The random numbers of a place: a stream of its own.
    static Stream stream_of_place(const Stream& stream, std::uint64_t place) {
        const Words words = philox(stream, static_cast<std::uint32_t>(place), Purpose::engine);
        return {.key = {words[0], words[1]}, .trial = stream.trial, .source = stream.source, .target = stream.target};
    }

    Sobol origins_;
    Sampler directions_;
};

}  // namespace ff::samplers
