#include "samplers/nets/sobol_raw.hpp"

#include "samplers/nets/sobol_directions.hpp"

#include <gtest/gtest.h>

namespace ff::samplers {
namespace {

/// Position in natural order of the point that Gray code visits at `index`.
std::uint32_t gray_code(std::uint32_t index) {
    return index ^ index >> 1;
}

TEST(SobolRaw, IsTheSequenceOfJoeAndKuoInGrayCodeOrderWithoutTheOrigin) {
    for (const std::uint32_t first : {0u, 1u, 1000u, 0x7ffffff0u}) {
        PointBlock block;
        block.size = 1024;
        SobolRaw({.points = max_points}).fill({}, first, block);
        for (std::size_t d = 0; d < max_dimension; ++d) {
            for (std::uint32_t i = 0; i < block.size; ++i) {
                EXPECT_EQ(block.coordinate[d][i], sobol_coordinate(gray_code(first + i + 1), d));
            }
        }
    }
}

}  // namespace
}  // namespace ff::samplers
