#include "samplers/point_sets/draw_set.hpp"

#include "core/support/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::samplers {

PointSet draw_set(const CatalogueEntry& sampler, const DrawnSet& wanted) {
    const SamplerInfo& info = sampler.info;
    if (!info.equal_weights)
        throw UserError(
            fmt::format("{} (its points have weights, which are not drawn). Choose another sampler.", info.name));
    if (info.most_trials != 0 && wanted.trial >= info.most_trials)
        throw UserError(fmt::format("trial {} ({} has {}, counted from 0). Take a smaller number.", wanted.trial,
                                    info.name, info.most_trials));
    const auto source = sampler.make({.points = wanted.points, .dimension = wanted.dimension});
    const Stream stream{.key = derive_key(Seed{wanted.seed}, fmt::format("points|{}|d={}|n={}", info.name,
                                                                         wanted.dimension, wanted.points)),
                        .trial = wanted.trial};
    PointSet set{wanted.points, wanted.dimension, 1, {}};
    set.coordinate.resize(wanted.points * wanted.dimension);
    PointBlock block;
    block.dimension = wanted.dimension;
    for_each_block(*source, stream, 0, wanted.points, block, [&](PointIndex first) {
        for (std::size_t d = 0; d < wanted.dimension; ++d)
            std::copy_n(block.coordinate[d].begin(), block.size, &set.coordinate[d * wanted.points + first]);
    });
    return set;
}

}  // namespace ff::samplers
