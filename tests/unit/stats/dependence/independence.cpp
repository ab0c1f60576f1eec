#include "stats/dependence/correlation.hpp"

#include "stats/basics/binomial.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace ff::stats {
namespace {

/// Normal variables, all with this correlation to each other.
std::vector<double> correlated(std::size_t repetitions, std::size_t variables, double correlation,
                               std::mt19937_64& engine) {
    std::normal_distribution<double> normal;
    std::vector<double> common(repetitions);
    for (double& value : common) value = std::sqrt(correlation) * normal(engine);
    std::vector<double> values;
    for (std::size_t j = 0; j < variables; ++j) {
        for (std::size_t i = 0; i < repetitions; ++i)
            values.push_back(7 + common[i] + std::sqrt(1 - correlation) * normal(engine));
    }
    return values;
}

/// How many of 400 are rejected at `alpha`.
std::uint64_t rejected(std::size_t repetitions, std::size_t variables, double correlation, double alpha) {
    std::mt19937_64 engine(11);
    std::uint64_t count = 0;
    for (int i = 0; i < 400; ++i) {
        const auto values = correlated(repetitions, variables, correlation, engine);
        count += *p_of_independence(values, repetitions) <= alpha ? 1u : 0u;
    }
    return count;
}

TEST(Independence, IsRejectedAtTheStatedRateWithoutCorrelation) {
    // It is an approximation: at 1 % a rate of 2 % is accepted, with a risk of 1e-4 for each of the nine comparisons; a
    // rate of 8 % is found with a power above 0.99.
    for (const std::size_t repetitions : {5u, 10u, 40u}) {
        for (const std::size_t variables : {2u, 20u, 300u})
            EXPECT_LT(clopper_pearson_interval({rejected(repetitions, variables, 0, 0.01), 400}, 1 - 2e-4).low, 0.02)
                << repetitions << " repetitions of " << variables;
    }
}

TEST(Independence, IsRejectedForCorrelatedVariables) {
    EXPECT_GT(rejected(10, 100, 0.3, 1e-3), 390u);
    EXPECT_GT(rejected(40, 2, 0.8, 1e-3), 390u);
}

TEST(Independence, NeedsFourRepetitionsOfTwoVariablesThatVary) {
    EXPECT_FALSE(p_of_independence(std::vector<double>{1, 2, 3, 4, 6, 5}, 3));
    EXPECT_FALSE(p_of_independence(std::vector<double>{1, 2, 3, 5, 7, 7, 7, 7}, 4));
    EXPECT_TRUE(p_of_independence(std::vector<double>{1, 2, 3, 5, 7, 7, 7, 8}, 4));
}

// Before rounding was allowed for, a constant 0.2 had a spread, and 4 of these 32 pairs a negative sum of squares.
TEST(Independence, TakesRoundingForWhatItIs) {
    std::vector<double> values(24, 0.2);
    for (std::size_t i = 0; i < 12; ++i) values[i] = static_cast<double>(i);
    EXPECT_FALSE(p_of_independence(values, 12)) << "one of the two does not vary";
    for (int i = 1; i <= 32; ++i) {
        const double a = 0.1 * i;
        const double b = 0.37 * i;
        const auto p =
            p_of_independence(std::vector<double>{b + a, b + a, b - a, b - a, b + a, b - a, b + a, b - a}, 4);
        ASSERT_TRUE(p);
        EXPECT_NEAR(*p, 1, 1e-9);
    }
}

}  // namespace
}  // namespace ff::stats
