#include "samplers/point_sets/draw_set.hpp"

#include "core/support/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::samplers {

PointSet draw_set(const CatalogueEntry& sampler, const DrawnSet& wanted) {
    const SamplerInfo& info = sampler.info;
    if (!info.equal_weights)
        throw UserError("{} (its points have weights, which are not drawn). Choose another sampler.", info.name);
    if (info.most_trials != 0 && wanted.trial >= info.most_trials)
        throw UserError("trial {} ({} has {}, counted from 0). Take a smaller number.", wanted.trial, info.name,
                        info.most_trials);
    const auto source = sampler.make({.points = wanted.points, .dimension = wanted.dimension});
    const Stream stream{.key = derive_key(Seed{wanted.seed}, fmt::format("points|{}|d={}|n={}", info.name,
                                                                         wanted.dimension, wanted.points)),
                        .trial = wanted.trial};
    return {wanted.points, wanted.dimension, 1, coordinates_of_set(*source, wanted.dimension, stream)};
}

std::vector<std::uint32_t> coordinates_of_set(const PointSource& source, std::size_t dimension, const Stream& stream,
                                              std::size_t part) {
    const std::uint64_t points = source.points();
    std::vector<std::uint32_t> coordinates(points * dimension);
    PointBlock block;
    block.dimension = dimension;
    for (PointIndex first = 0; first < points; first += block.size) {
        block.size = std::min<std::uint64_t>(part, points - first);
        source.fill(stream, first, block);
        for (std::size_t d = 0; d < dimension; ++d)
            std::copy_n(block.coordinate[d].begin(), block.size, &coordinates[d * points + first]);
    }
    return coordinates;
}

}  // namespace ff::samplers
