#include "samplers/grids/gauss_legendre.hpp"

#include "core/support/error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace ff::samplers {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// The k-th largest node of the rule with n nodes and its weight, on [0, 1], from
//   from mpmath import *; mp.dps = 60
//   x = findroot(lambda t: legendre(n, t), cos(pi * (k - .25) / (n + .5)), verify=False)
//   print(nstr((1 + x) / 2, 20), nstr(1 / ((1 - x * x) * diff(lambda t: legendre(n, t), x) ** 2), 20))
struct Known {
    std::uint32_t n;
    std::size_t k;
    double node;
    double weight;
};
constexpr std::array<Known, 6> known{{
    {5, 1, 0.9530899229693319964, 0.11846344252809454376},
    {5, 2, 0.76923465505284154552, 0.23931433524968323402},
    {5, 3, 0.5, 0.28444444444444444444},
    {64, 1, 0.99965252086788606973, 0.00089164036084821647365},
    {64, 2, 0.99817005838597763967, 0.0020735166302812338176},
    {64, 32, 0.51217514633171221625, 0.024345478504569860192},
}};

TEST(GaussRule, HasKnownNodesAndWeightsToDoublePrecision) {
    for (const Known& value : known) {
        const GaussRule rule = gauss_rule(value.n);
        EXPECT_NEAR(rule.nodes[value.n - value.k], value.node, epsilon);
        EXPECT_NEAR(rule.weights[value.n - value.k], value.weight, 2 * epsilon * value.weight);
        EXPECT_NEAR(rule.nodes[value.k - 1], 1 - value.node, epsilon);
        EXPECT_EQ(rule.weights[value.k - 1], rule.weights[value.n - value.k]);
    }
}

TEST(GaussRule, IntegratesPolynomialsUpToDegree2nMinus1) {
    for (std::uint32_t n = 1; n <= GaussLegendre::max_nodes; ++n) {
        const GaussRule rule = gauss_rule(n);
        for (std::uint32_t degree = 0; degree < 2 * n; ++degree) {
            double sum = 0;
            for (std::size_t i = 0; i < n; ++i) sum += rule.weights[i] * std::pow(rule.nodes[i], degree);
            // Nodes are right to epsilon, so x^degree to degree * epsilon at most, and the sum rounds n times.
            EXPECT_NEAR(sum, 1.0 / (degree + 1), (degree + n + 4) * epsilon / (degree + 1)) << n << " " << degree;
        }
    }
}

TEST(GaussRule, FailsAtDegree2n) {
    for (std::uint32_t n = 1; n <= 8; ++n) {
        const GaussRule rule = gauss_rule(n);
        double sum = 0;
        for (std::size_t i = 0; i < n; ++i) sum += rule.weights[i] * std::pow(rule.nodes[i], 2 * n);
        EXPECT_GT(std::abs(sum - 1.0 / (2 * n + 1)), 1e-12);
    }
}

TEST(GaussRule, AscendsWithWeightsThatSumToOne) {
    for (std::uint32_t n = 1; n <= GaussLegendre::max_nodes; ++n) {
        const GaussRule rule = gauss_rule(n);
        EXPECT_TRUE(std::is_sorted(rule.nodes.begin(), rule.nodes.end()));
        EXPECT_NEAR(std::accumulate(rule.weights.begin(), rule.weights.end(), 0.0), 1, n * epsilon);
    }
}

TEST(GaussLegendre, MakesTensorProductsWithTheLastCoordinateFastest) {
    const GaussLegendre product({.source_nodes = 2, .target_nodes = 3});
    const GaussRule source = gauss_rule(2);
    const GaussRule target = gauss_rule(3);
    ASSERT_EQ(product.points(), 36u);
    WeightedBlock block;
    block.size = 36;
    product.fill({}, 0, block);
    for (std::size_t i = 0; i < 36; ++i) {
        EXPECT_EQ(block.coordinate[0][i], source.nodes[i / 18]);
        EXPECT_EQ(block.coordinate[1][i], source.nodes[i / 9 % 2]);
        EXPECT_EQ(block.coordinate[2][i], target.nodes[i / 3 % 3]);
        EXPECT_EQ(block.coordinate[3][i], target.nodes[i % 3]);
        EXPECT_DOUBLE_EQ(block.weight[i], source.weights[i / 18] * source.weights[i / 9 % 2] *
                                              target.weights[i / 3 % 3] * target.weights[i % 3]);
    }
}

TEST(GaussLegendre, IsExchangeableWithEqualNodesOnly) {
    EXPECT_TRUE(GaussLegendre({.source_nodes = 5, .target_nodes = 5}).exchangeable());
    EXPECT_FALSE(GaussLegendre({.source_nodes = 5, .target_nodes = 6}).exchangeable());
    EXPECT_FALSE(GaussLegendre({.dimension = 2, .source_nodes = 5, .target_nodes = 5}).exchangeable());
}

TEST(GaussLegendre, RefusesNumbersOfNodesBeyond1To64) {
    EXPECT_THROW(GaussLegendre({.source_nodes = 0, .target_nodes = 5}), UserError);
    EXPECT_THROW(GaussLegendre({.source_nodes = 5, .target_nodes = 65}), UserError);
    EXPECT_NO_THROW(GaussLegendre({.source_nodes = 1, .target_nodes = 64}));
    EXPECT_NO_THROW(GaussLegendre({.dimension = 2, .source_nodes = 5}));  // no target in 2-D
}

}  // namespace
}  // namespace ff::samplers
