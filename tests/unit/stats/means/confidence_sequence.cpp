#include "stats/means/mean_interval.hpp"

#include "stats/basics/distributions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace ff::stats {
namespace {

std::vector<double> normal_values(std::size_t n, std::uint64_t seed) {
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal(3, 2);
    std::vector<double> values(n);
    for (double& value : values) value = normal(engine);
    return values;
}

// At each end the Bayes factor, written down anew, is 1 / (1 - level).
TEST(NormalSequence, EndsWhereTheBayesFactorReachesItsLimit) {
    const auto values = normal_values(60, 1);
    const double level = 0.99;
    const auto interval = normal_sequence(values, 40, level);
    double mean = 0;
    for (const double value : values) mean += value / 60;
    double squares = 0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    const double evidence = -2 * std::log(1 - level);
    const double g = (evidence + std::log1p(evidence)) / 40;
    for (const double end : {interval.low, interval.high}) {
        const double r = 60 * (mean - end) * (mean - end) / squares;
        const double factor = std::pow(1 + 60 * g, -0.5) * std::pow((1 + r) / (1 + r / (1 + 60 * g)), 30);
        EXPECT_NEAR(factor, 100, 1e-6);
    }
}

TEST(NormalSequence, IsWiderThanStudentsAndOpenForFewValues) {
    const auto values = normal_values(100, 2);
    const double student = 2 * student_critical(99, 0.005) * 2 / 10;
    const double width = normal_sequence(values, 100, 0.99).width();
    EXPECT_GT(width, student);
    EXPECT_LT(width, 2 * student);
    EXPECT_TRUE(std::isinf(normal_sequence(std::vector<double>{1, 2}, 100, 0.9999).width()));
}

TEST(BoundedSequence, ShrinksAndStaysInsideTheBounds) {
    std::vector<double> values;
    double before = 10;
    for (int i = 0; i < 2000; ++i) {
        values.push_back(i % 4 == 0 ? 12 : 2);
        const auto interval = bounded_sequence(values, 2, 12, 0.99);
        EXPECT_GE(interval.low, 2);
        EXPECT_LE(interval.high, 12);
        EXPECT_LE(interval.width(), before);
        before = interval.width();
    }
    EXPECT_TRUE(bounded_sequence(values, 2, 12, 0.99).contains(4.5));
    EXPECT_LT(before, 1.5);
}

}  // namespace
}  // namespace ff::stats
