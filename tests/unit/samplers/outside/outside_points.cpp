#include "samplers/outside/outside_points.hpp"

#include "core/support/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ff::samplers {
namespace {

/// Coordinate d of point i is 1000 * trial + 10 * i + d.
PointSet counted(const SetRequest& request) {
    PointSet set{request.points, request.dimension, 1, {}};
    for (std::uint32_t d = 0; d < request.dimension; ++d) {
        for (std::uint32_t i = 0; i < request.points; ++i) set.coordinate.push_back(1000 * request.trial + 10 * i + d);
    }
    return set;
}

TEST(OutsidePoints, AreMadeOnceForAllPartsOfASet) {
    int made = 0;
    const auto points = outside_points(100, true, parts_of([&](const SetRequest& request, PointSet& set) {
                                           ++made;
                                           set = counted(request);
                                       }));
    PointBlock block;
    block.dimension = 2;
    block.size = 10;
    for (const std::uint32_t trial : {3u, 4u, 3u}) {
        for (PointIndex first = 0; first < 100; first += 10) {
            points->fill({.key = {1, 2}, .trial = trial}, first, block);
            EXPECT_EQ(block.coordinate[1][7], 1000 * trial + 10 * (first + 7) + 1);
        }
    }
    EXPECT_EQ(made, 3);
    EXPECT_EQ(points->points(), 100u);
    EXPECT_TRUE(points->randomised());
}

TEST(OutsidePoints, AreMadeAgainAfterAFailure) {
    bool fails = true;
    const auto points = outside_points(4, true, parts_of([&](const SetRequest& request, PointSet& set) {
                                           if (fails) throw UserError("no");
                                           set = counted(request);
                                       }));
    PointBlock block;
    block.size = 4;
    EXPECT_THROW(points->fill({}, 0, block), UserError);
    fails = false;
    points->fill({}, 0, block);
    EXPECT_EQ(block.coordinate[3][3], 33u);
}

TEST(OutsidePoints, HaveADifferentSeedForEachStream) {
    const Stream stream{.key = {1, 2}, .trial = 3, .source = 4, .target = 5};
    std::vector<std::uint64_t> seeds{request_of(stream, 8, 4).seed};
    for (const Stream& other : {Stream{.key = {2, 2}, .trial = 3, .source = 4, .target = 5},
                                Stream{.key = {1, 2}, .trial = 2, .source = 4, .target = 5},
                                Stream{.key = {1, 2}, .trial = 3, .source = 5, .target = 5},
                                Stream{.key = {1, 2}, .trial = 3, .source = 4, .target = 4}}) {
        const auto request = request_of(other, 8, 4);
        EXPECT_EQ(request.trial, other.trial);
        for (const std::uint64_t seed : seeds) EXPECT_NE(request.seed, seed);
        seeds.push_back(request.seed);
    }
}

TEST(OutsidePoints, RefuseSetsTooLargeForMemory) {
    EXPECT_THROW(expect_whole("mine", {std::uint64_t{1} << 32, 4, 0, 0}), UserError);
}

}  // namespace
}  // namespace ff::samplers
