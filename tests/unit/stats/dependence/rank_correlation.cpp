#include "stats/dependence/correlation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

namespace ff::stats {
namespace {

using Numbers = std::vector<double>;

TEST(RankCorrelation, CountsPairsThatAgree) {
    // R: cor(1:6, c(2, 1, 4, 3, 6, 5), method = "kendall") is 0.6; with ties cor(c(1, 1, 2, 3, 4, 5), 1:6) is
    // 0.9660918.
    EXPECT_NEAR(rank_correlation(Numbers{1, 2, 3, 4, 5, 6}, Numbers{2, 1, 4, 3, 6, 5}, 0.95)->tau, 0.6, 1e-12);
    EXPECT_NEAR(rank_correlation(Numbers{1, 1, 2, 3, 4, 5}, Numbers{1, 2, 3, 4, 5, 6}, 0.95)->tau, 0.9660918, 1e-7);
}

TEST(RankCorrelation, IsUncertainForFewAgreeingPairs) {
    const auto same = rank_correlation(Numbers{1, 2, 3, 4, 5, 6}, Numbers{1, 2, 3, 4, 5, 6}, 0.95);
    EXPECT_EQ(same->tau, 1);
    EXPECT_NEAR(same->interval.high, 1, 1e-12);
    EXPECT_LT(same->interval.low, 0.5);
    const auto opposite = rank_correlation(Numbers{1, 2, 3, 4, 5, 6}, Numbers{6, 5, 4, 3, 2, 1}, 0.95);
    EXPECT_NEAR(opposite->interval.low, -1, 1e-12);
    EXPECT_NEAR(opposite->interval.high, -same->interval.low, 1e-12);
}

TEST(RankCorrelation, IsEmptyForTooFewOrEqualValues) {
    EXPECT_FALSE(rank_correlation(Numbers{1, 2, 3, 4, 5}, Numbers{1, 2, 3, 4, 5}, 0.95));
    EXPECT_FALSE(rank_correlation(Numbers{1, 1, 1, 1, 1, 1}, Numbers{1, 2, 3, 4, 5, 6}, 0.95));
}

/// How many of 4000 intervals of 95 % hold tau of the pairs that `draw(engine)` gives.
template <class Draw>
int held(std::size_t n, double tau, const Draw& draw) {
    std::mt19937_64 engine(7);
    int count = 0;
    for (int i = 0; i < 4000; ++i) {
        Numbers x(n);
        Numbers y(n);
        for (std::size_t k = 0; k < n; ++k) std::tie(x[k], y[k]) = draw(engine);
        count += rank_correlation(x, y, 0.95)->interval.contains(tau) ? 1 : 0;
    }
    return count;
}

// Fewer than 3733 of 4000 have a probability of 1e-4 or less at a coverage of 0.95; at 0.92, of 0.999.
TEST(RankCorrelation, IntervalsCoverAtTheirLevel) {
    for (const std::size_t n : {8u, 14u, 40u}) {
        for (const double correlation : {0.0, 0.5, 0.9}) {
            std::normal_distribution<double> normal;
            const auto pair = [&](std::mt19937_64& engine) {
                const double x = normal(engine);
                return std::pair(x, correlation * x + std::sqrt(1 - correlation * correlation) * normal(engine));
            };
            EXPECT_GE(held(n, 2 / std::numbers::pi * std::asin(correlation), pair), 3733) << n << ' ' << correlation;
        }
        // In the same order with probability 0.8, else in the opposite one: pairs of points both agree if both do, or
        // are of two kinds, which agree as often as not. So tau is 0.64 - 0.04.
        const auto mixed = [](std::mt19937_64& engine) {
            std::uniform_real_distribution<double> uniform;
            const double x = uniform(engine);
            return std::pair(x, uniform(engine) < 0.8 ? x : 1 - x);
        };
        EXPECT_GE(held(n, 0.6, mixed), 3733) << n;
    }
}

}  // namespace
}  // namespace ff::stats
