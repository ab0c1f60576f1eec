#pragma once

#include "tests/support/philox_points.hpp"

#include <memory>

namespace ff::test {

/// `size` independent points; different ones for every `number`.
inline std::unique_ptr<PointBlock> random_block(std::uint32_t number, std::size_t size = block_capacity) {
    auto block = std::make_unique<PointBlock>();
    block->size = size;
    PhiloxPoints(size).fill({.key = {7, 11}, .trial = number}, 0, *block);
    return block;
}

}  // namespace ff::test
