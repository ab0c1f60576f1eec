#include "samplers/support/philox_block.hpp"

#include "tests/unit/core/tracing/instruction_sets.hpp"

#include <gtest/gtest.h>

#include <array>

namespace ff::samplers {
namespace {

constexpr Stream philox_stream{
    .key = {0x243f6a88, 0x85a308d3}, .trial = 0x13198a2e, .source = 0x03707344, .target = 77};

TEST(PhiloxBlock, EqualsScalarPhiloxInEveryLaneAndInstructionSet) {
    for (const PointIndex first : {PointIndex{0}, PointIndex{625}, PointIndex{0xfffffff0u}}) {
        for (const std::size_t size : {std::size_t{1}, std::size_t{15}, std::size_t{16}}) {
            const auto sets = test::with_each_instruction_set([&] {
                PointBlock block;
                block.size = size;
                philox_block(philox_stream, Purpose::scramble, first, block);
                bool equal = true;
                for (std::size_t i = 0; i < size; ++i) {
                    const Words words = philox(philox_stream, static_cast<std::uint32_t>(first + i), Purpose::scramble);
                    for (std::size_t d = 0; d < max_dimension; ++d) equal &= block.coordinate[d][i] == words[d];
                }
                return equal;
            });
            for (const bool equal : sets) EXPECT_TRUE(equal);
        }
    }
}

TEST(PhiloxBlock, FillsAWholeBlockTheSameWithEveryInstructionSet) {
    const auto sets = test::with_each_instruction_set([] {
        PointBlock block;
        block.size = block_capacity;
        philox_block(philox_stream, Purpose::coordinates, 3, block);
        return block.coordinate;
    });
    for (const auto& coordinate : sets) EXPECT_EQ(coordinate, sets.front());
    EXPECT_EQ(sets.front()[3][1023], philox(philox_stream, 1026, Purpose::coordinates)[3]);
}

TEST(PhiloxBlock, LeavesRowsBeyondTheDimensionAlone) {
    PointBlock block;
    block.dimension = 2;
    block.size = 100;
    block.coordinate[2].fill(7);
    philox_block(philox_stream, Purpose::coordinates, 0, block);
    for (const std::uint32_t x : block.coordinate[2]) EXPECT_EQ(x, 7u);
}

}  // namespace
}  // namespace ff::samplers
