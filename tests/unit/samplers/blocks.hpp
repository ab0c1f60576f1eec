#pragma once

#include "core/points/points.hpp"

#include <cstddef>

namespace ff::test {

/// `size` points from `first` on, of a sampler or any other source.
template <class Source>
PointBlock block_of(const Source& source, const Stream& stream, PointIndex first, std::size_t size,
                    std::size_t dimension = max_dimension) {
    PointBlock block;
    block.dimension = dimension;
    block.size = size;
    source.fill(stream, first, block);
    return block;
}

}  // namespace ff::test
