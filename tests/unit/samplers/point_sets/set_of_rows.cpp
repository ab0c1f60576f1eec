#include "samplers/point_sets/set_of_rows.hpp"

#include "core/support/error.hpp"
#include "tests/unit/core/tracing/instruction_sets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace ff::samplers {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

// Sets have every length and dimension, so that on every CPU vectors end within a set, and hold numbers next to
// multiples of 2^-32.
TEST(SetOfRows, RoundsDownToMultiplesOfTwoToTheMinus32) {
    std::mt19937_64 words;
    for (std::size_t dimension = 1; dimension <= max_dimension; ++dimension) {
        for (std::uint64_t points = 1; points < 40; ++points) {
            std::vector<double> rows(points * dimension);
            for (double& x : rows) x = static_cast<double>(words() >> 11) * 0x1p-53;
            rows.front() = 0x1.fffffffffffffp-1;
            rows.back() = points % 2 == 0 ? -0.0 : 0x1.8p-31 - 0x1p-80;
            const auto sets = test::with_each_instruction_set([&] {
                PointSet set;
                set_of_rows(rows, points, dimension, "mine", set);
                return set;
            });
            for (const PointSet& set : sets) {
                for (std::uint64_t i = 0; i < points; ++i) {
                    for (std::size_t d = 0; d < dimension; ++d)
                        ASSERT_EQ(set.row(0, d)[i], static_cast<std::uint32_t>(rows[i * dimension + d] * 0x1p32));
                }
            }
        }
    }
}

TEST(SetOfRows, NamesThePlaceOfANumberOutsideTheCube) {
    EXPECT_THAT(
        [] {
            PointSet set;
            set_of_rows(std::vector<double>{0, 0.25, 0.5, 1}, 2, 2, "mine", set);
        },
        ThrowsMessage<UserError>(HasSubstr("mine: point 1, coordinate 1 is 1 (counted from 0; not in [0, 1))")));
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {-0x1p-1074, -0.5, 1.0, 2.0, 0x1p20, -0x1p20, 0x1p21, 0x1p52, 1e300, -1e300, infinity,
                             -infinity, std::numeric_limits<double>::quiet_NaN()}) {
        for (std::size_t at = 0; at < 68; ++at) {
            std::vector<double> rows(68, 0.5);
            rows[at] = bad;
            PointSet set;
            EXPECT_THAT([&] { set_of_rows(rows, 17, 4, "mine", set); },
                        ThrowsMessage<UserError>(
                            HasSubstr("point " + std::to_string(at / 4) + ", coordinate " + std::to_string(at % 4))));
        }
    }
}

}  // namespace
}  // namespace ff::samplers
