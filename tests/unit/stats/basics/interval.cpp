#include "stats/basics/interval.hpp"

#include <gtest/gtest.h>

namespace ff::stats {
namespace {

TEST(Interval, ContainsItsEnds) {
    const Interval interval{.low = 1, .high = 4, .level = 0.9, .method = "test", .n = 3};
    EXPECT_TRUE(interval.contains(1) && interval.contains(4) && interval.contains(2));
    EXPECT_FALSE(interval.contains(0.999) || interval.contains(4.001));
    EXPECT_EQ(interval.width(), 3);
}

TEST(SquareRoot, KeepsLevelMethodAndCount) {
    const Interval root = square_root({.low = 1, .high = 4, .level = 0.9, .method = "test", .n = 3});
    EXPECT_EQ(root.low, 1);
    EXPECT_EQ(root.high, 2);
    EXPECT_EQ(root.level, 0.9);
    EXPECT_EQ(root.method, "test");
    EXPECT_EQ(root.n, 3u);
}

}  // namespace
}  // namespace ff::stats
