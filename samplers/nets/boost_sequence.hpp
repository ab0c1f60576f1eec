#pragma once

#include "core/points/points.hpp"

#include <array>

namespace ff::samplers {

/// Fills a block from point `first` on with a quasi-random engine of Boost.Random, keeping the upper 32 of 64 bits.
/// Engines are costly to make and cheap to copy: there is one original for each dimension.
template <class Engine>
void fill_from_engine(PointIndex first, PointBlock& block) {
    static const std::array<Engine, max_dimension> originals{Engine(1), Engine(2), Engine(3), Engine(4)};
    Engine engine = originals[block.dimension - 1];
    engine.seed(first);
    for (std::size_t i = 0; i < block.size; ++i) {
        for (std::size_t d = 0; d < block.dimension; ++d) {
            block.coordinate[d][i] = static_cast<std::uint32_t>(engine() >> 32);
        }
    }
}

}  // namespace ff::samplers
