#include "stats/change_point.hpp"

#include "tests/support/statistical_assertions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace ff::stats {
namespace {

std::vector<double> normal_series(std::size_t n, std::uint64_t seed, std::size_t change, double shift) {
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal;
    std::vector<double> values(n);
    for (std::size_t i = 0; i < n; ++i) values[i] = normal(engine) + (i >= change ? shift : 0);
    return values;
}

ResamplingPlan change_plan() {
    return {derive_key(Seed{1}, "test"), 199};
}

TEST(FindChange, FindsWhereTheLevelChanges) {
    const auto found = find_change(normal_series(40, 1, 25, 5), change_plan());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->first, 25u);
    EXPECT_NEAR(found->after - found->before, 5, 1.5);
    EXPECT_EQ(found->p, 1.0 / 200);
}

TEST(FindChange, IsEmptyForFewValuesAndForEqualOnes) {
    EXPECT_FALSE(find_change(std::vector<double>{1, 2, 3}, change_plan()));
    EXPECT_FALSE(find_change(std::vector<double>(20, 1.0), change_plan()));
}

// 20 values that may be divided into halves of 10 in 184756 ways, each as good as its mirror image.
TEST(FindChange, KnowsTheLeastP) {
    EXPECT_NEAR(least_change_p(20), 2.0 / 184756, 1e-10);
}

// Without a change p is at most 0.05 in 5 % of series; 2000 seeds, a false alarm in 1e-7, 10 % would be noticed.
TEST(FindChange, HoldsItsLevelOnSkewedSeries) {
    std::uint64_t found = 0;
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        auto values = normal_series(15, seed, 15, 0);
        for (double& value : values) value = std::exp(value);
        found += find_change(values, {derive_key(Seed{seed}, "test"), 99})->p <= 0.05 ? 1u : 0u;
    }
    EXPECT_TRUE(test::has_probability(found, 2000, 0.05, {.detects = 0.05}));
}

}  // namespace
}  // namespace ff::stats
