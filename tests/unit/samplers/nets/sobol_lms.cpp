#include "samplers/nets/sobol_lms.hpp"

#include "samplers/nets/sobol_directions.hpp"
#include "tests/unit/samplers/nets/net.hpp"

#include <gtest/gtest.h>

namespace ff::samplers {
namespace {

constexpr Stream lms_stream{.key = {8, 3}, .trial = 1, .source = 2, .target = 3};

test::Coordinates lms_points(std::size_t size, PointIndex first, const Stream& with = lms_stream) {
    PointBlock block;
    block.size = size;
    SobolLms({.points = first + size}).fill(with, first, block);
    test::Coordinates points;
    for (std::size_t d = 0; d < max_dimension; ++d) {
        points[d].assign(block.coordinate[d].begin(), block.coordinate[d].begin() + static_cast<std::ptrdiff_t>(size));
    }
    return points;
}

TEST(SobolLms, MultipliesByALowerTriangularMatrixAndShifts) {
    // Bit by bit from the definition: row r of the matrix has ones on the diagonal and random bits before it.
    for (const PointIndex first : {PointIndex{0}, PointIndex{0xfffffc00}}) {
        const auto points = lms_points(1024, first);
        for (std::size_t d = 0; d < max_dimension; ++d) {
            for (std::uint32_t i = 0; i < 1024; i += 31) {
                const std::uint32_t before = sobol_coordinate(static_cast<std::uint32_t>(first) + i, d);
                std::uint32_t after = 0;
                for (std::uint32_t row = 0; row < 32; ++row) {
                    std::uint32_t digit = before >> (31 - row) & 1u;
                    for (std::uint32_t c = 0; c < row; ++c) {
                        const std::uint32_t entry = philox(lms_stream, c, Purpose::scramble)[d] >> (31 - row) & 1u;
                        digit ^= entry & before >> (31 - c);
                    }
                    after = after << 1 | (digit & 1u);
                }
                EXPECT_EQ(points[d][i], after ^ philox(lms_stream, 32, Purpose::scramble)[d]);
            }
        }
    }
}

TEST(SobolLms, KeepsTheNetParameter) {
    for (unsigned m = 4; m <= 10; ++m) {
        const std::uint32_t size = 1u << m;
        for (const std::uint32_t first : {0u, 3 * size}) {
            test::Coordinates plain;
            for (std::size_t d = 0; d < max_dimension; ++d) {
                for (std::uint32_t i = first; i < first + size; ++i) plain[d].push_back(sobol_coordinate(i, d));
            }
            EXPECT_EQ(test::net_parameter(lms_points(size, first), m), test::net_parameter(plain, m));
        }
    }
}

TEST(SobolLms, ScramblesEveryStreamDifferently) {
    Stream other = lms_stream;
    ++other.trial;
    const auto shape = [](const test::Coordinates& points, std::size_t d) {
        std::vector<std::uint32_t> differences;  // free of the shift
        for (const std::uint32_t x : points[d]) differences.push_back(x ^ points[d][0]);
        return differences;
    };
    for (std::size_t d = 0; d < max_dimension; ++d) {
        EXPECT_NE(shape(lms_points(256, 0), d), shape(lms_points(256, 0, other), d));
    }
}

}  // namespace
}  // namespace ff::samplers
