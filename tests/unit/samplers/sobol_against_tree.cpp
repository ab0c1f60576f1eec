#include "samplers/sobol.hpp"
#include "samplers/sobol_directions.hpp"
#include "stats/variance_test.hpp"
#include "tests/support/owen_tree.hpp"
#include "tests/support/statistical_assertions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

// Does the hash do what true nested uniform scrambling (Owen's tree) does to estimates? For a few integrands, smooth
// and not: both means are right, and both variances agree.

namespace ff::test {
namespace {

constexpr std::uint32_t replicates = 1000;
constexpr std::size_t points = 256;

using Fill = void (*)(const Stream&, PointBlock&);

void fill_hash(const Stream& stream, PointBlock& block) {
    samplers::Sobol({.points = points}).fill(stream, 0, block);
}

void fill_tree(const Stream& stream, PointBlock& block) {
    fill_sobol_tree(stream, 0, block);
}

/// A random digital shift alone: it keeps the net and is unbiased, but scrambles nothing.
void fill_shift(const Stream& stream, PointBlock& block) {
    const Words shift = philox(stream, 0, Purpose::scramble);
    for (std::size_t d = 0; d < block.dimension; ++d) {
        for (std::uint32_t i = 0; i < block.size; ++i) {
            block.coordinate[d][i] = samplers::sobol_coordinate(i, d) ^ shift[d];
        }
    }
}

struct Case {
    std::string name;
    double integral;
    double (*integrand)(double, double, double, double);
};

/// How gtest prints a parameter.
void PrintTo(const Case& test_case, std::ostream* out) {
    *out << test_case.name;
}

std::vector<double> estimates(Fill fill, const Case& test_case) {
    std::vector<double> result;
    PointBlock block;
    block.size = points;
    for (std::uint32_t trial = 0; trial < replicates; ++trial) {
        fill({.key = {20261120, 1}, .trial = trial}, block);
        double sum = 0;
        for (std::size_t i = 0; i < points; ++i) {
            const auto x = [&](std::size_t d) { return (block.coordinate[d][i] + 0.5) * 0x1p-32; };
            sum += test_case.integrand(x(0), x(1), x(2), x(3));
        }
        result.push_back(sum / points);
    }
    return result;
}

// A false alarm in one run of 10^6. With 1000 replicates of roughly normal estimates, variances that differ by a factor
// of 1.7 are noticed with probability above .99 (sd of the ln ratio .063; 4.9 + 2.3 standard errors are a factor 1.58).
constexpr double alpha = 1e-6;

bool same_variance(const std::vector<double>& a, const std::vector<double>& b) {
    return stats::test_variances_brown_forsythe(a, b).value().p > alpha;
}

class SobolAgainstTree : public testing::TestWithParam<Case> {};

TEST_P(SobolAgainstTree, HasTheSameMeanAndVariance) {
    const auto hash = estimates(fill_hash, GetParam());
    const auto tree = estimates(fill_tree, GetParam());
    EXPECT_TRUE(unbiased(hash, GetParam().integral, {.alpha = alpha, .detects = 0.01 * GetParam().integral}));
    EXPECT_TRUE(unbiased(tree, GetParam().integral, {.alpha = alpha, .detects = 0.01 * GetParam().integral}));
    EXPECT_TRUE(same_variance(hash, tree));
}

INSTANTIATE_TEST_SUITE_P(
    Integrands, SobolAgainstTree,
    testing::Values(
        Case{"SmoothProduct", 1, [](double x, double y, double z, double w) { return 16 * x * y * z * w; }},
        Case{"Exponential", std::pow(std::exp(1.0) - 1, 4),
             [](double x, double y, double z, double w) { return std::exp(x + y + z + w); }},
        Case{"HalfSpace", 0.5, [](double x, double y, double z, double w) { return x + y + z + w < 2 ? 1.0 : 0.0; }},
        // python3 -c "from math import pi; print(pi**2 / 32)", the positive part of the 4-D unit ball
        Case{"Ball", 0.30842513753404244,
             [](double x, double y, double z, double w) { return x * x + y * y + z * z + w * w < 1 ? 1.0 : 0.0; }}),
    [](const auto& parameter) { return parameter.param.name; });

TEST(SobolAgainstTreeCheck, CatchesADigitalShiftInPlaceOfScrambling) {
    const Case smooth{"", 1, [](double x, double y, double z, double w) { return 16 * x * y * z * w; }};
    EXPECT_FALSE(same_variance(estimates(fill_shift, smooth), estimates(fill_tree, smooth)));
}

}  // namespace
}  // namespace ff::test
