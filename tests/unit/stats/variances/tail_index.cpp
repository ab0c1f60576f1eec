#include "stats/variances/tails.hpp"

#include "tests/support/statistical_assertions.hpp"
#include "tests/unit/stats/samples.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace ff::stats {
namespace {

/// Pareto values, P(X > x) = x^-index from 1 on.
std::vector<double> pareto_sample(double index, std::size_t n, std::mt19937_64& engine) {
    auto values = test::sample(std::uniform_real_distribution<double>(), n, engine);
    for (double& value : values) value = std::pow(1 - value, -1 / index);
    return values;
}

// Above any threshold Pareto values follow a generalised Pareto law of shape 1 / index exactly.
// Risks: 1e-6; a bias of .03 in the shape is noticed with power .99.
TEST(TailFit, FindsTheIndexOfParetoValues) {
    std::mt19937_64 engine(1);
    for (const double index : {1.5, 2.0, 3.0}) {
        std::vector<double> shapes;
        std::vector<double> hill;
        for (int run = 0; run < 250; ++run) {
            const auto values = pareto_sample(index, 3000, engine);
            shapes.push_back(fit_tail(values)->shape);
            hill.push_back(fit_tail_hill(values, 300)->shape);
        }
        EXPECT_TRUE(test::unbiased(shapes, 1 / index, {.detects = 0.05})) << "index " << index;
        EXPECT_TRUE(test::unbiased(hill, 1 / index, {.detects = 0.03})) << "index " << index;
    }
}

TEST(TailFit, StandardErrorIsTheScatterOfTheShape) {
    std::mt19937_64 engine(2);
    std::vector<double> scores;
    for (int run = 0; run < 400; ++run) {
        const auto fit = fit_tail(pareto_sample(1.5, 2000, engine));
        scores.push_back(std::pow((fit->shape - 1 / 1.5) / fit->standard_error, 2));
    }
    EXPECT_TRUE(test::unbiased(scores, 1, {.detects = 0.7}));  // mean square score; risks 1e-6 and .01
}

TEST(TailFit, IsInvariantUnderShiftAndScaleUnlikeHills) {
    std::mt19937_64 engine(3);
    const auto values = pareto_sample(2, 2000, engine);
    auto moved = values;
    for (double& value : moved) value = 100 + 7 * value;
    EXPECT_NEAR(fit_tail(moved)->shape, fit_tail(values)->shape, 1e-9);
    EXPECT_LT(fit_tail_hill(moved, 200)->shape, fit_tail_hill(values, 200)->shape / 2);
}

TEST(TailFit, IsEmptyWithoutEnoughOrTooDiscreteValues) {
    std::mt19937_64 engine(4);
    EXPECT_FALSE(fit_tail(test::normal_sample(199, engine)));
    EXPECT_TRUE(fit_tail(test::normal_sample(200, engine)));
    EXPECT_FALSE(fit_tail(std::vector<double>(1000, 0.2)));
    EXPECT_FALSE(fit_tail({}));
    EXPECT_FALSE(fit_tail_hill(std::array{1.0, 2.0}, 2));
    EXPECT_FALSE(fit_tail_hill(std::array{-1.0, -2.0, 3.0}, 2));
    EXPECT_FALSE(fit_tail_hill(std::array{2.0, 2.0, 2.0}, 2));
}

TEST(TailFit, HasNoIndexForBoundedValues) {
    std::mt19937_64 engine(5);
    const auto fit = fit_tail(test::sample(std::uniform_real_distribution<double>(), 5000, engine));
    EXPECT_LT(fit->shape, -0.7);  // -1 for uniform values
    EXPECT_FALSE(fit->index());
}

struct Verdicts {
    std::uint64_t finite = 0, infinite = 0;
};

template <class Sampler>
Verdicts verdicts(int runs, Sampler sampler) {
    Verdicts count;
    for (int run = 0; run < runs; ++run) {
        const VarianceHealth health = judge_variance(*fit_tail(sampler()));
        count.finite += health == VarianceHealth::finite ? 1u : 0u;
        count.infinite += health == VarianceHealth::infinite ? 1u : 0u;
    }
    return count;
}

TEST(JudgeVariance, CallsNormalAndBoundedDataFiniteAndNeverInfinite) {
    std::mt19937_64 engine(6);
    const Verdicts normal = verdicts(1000, [&] { return test::normal_sample(1000, engine); });
    EXPECT_EQ(normal.infinite, 0u);
    EXPECT_GT(normal.finite, 990u);
    const Verdicts uniform =
        verdicts(300, [&] { return test::sample(std::uniform_real_distribution<double>(), 1000, engine); });
    EXPECT_EQ(uniform.infinite, 0u);
    EXPECT_EQ(uniform.finite, 300u);
}

TEST(JudgeVariance, CallsParetoTailsOfIndexOnePointFiveInfiniteAndOfThreeFinite) {
    std::mt19937_64 engine(7);
    const Verdicts heavy = verdicts(60, [&] { return pareto_sample(1.5, 30'000, engine); });
    EXPECT_GT(heavy.infinite, 55u);  // shape .667 +- .030, five standard errors above 1/2
    EXPECT_EQ(heavy.finite, 0u);
    const Verdicts light = verdicts(60, [&] { return pareto_sample(3, 30'000, engine); });
    EXPECT_GT(light.finite, 55u);
    EXPECT_EQ(light.infinite, 0u);
}

// A thousand values have a hundred exceedances: too few to prove an infinite variance, but no clean bill either.
TEST(JudgeVariance, IsMostlyUndecidedAboutAThousandHeavyTailedValues) {
    std::mt19937_64 engine(8);
    const Verdicts heavy = verdicts(1000, [&] { return pareto_sample(1.5, 1000, engine); });
    EXPECT_TRUE(test::has_probability_at_most(heavy.finite, 1000, 0.01, {.detects = 0.033}));
    EXPECT_LT(heavy.infinite, 500u);
}

// At index 2 exactly each verdict is wrong some alpha = .01 of the time. Risks: 1e-6 above .015; .03 more at .99.
TEST(JudgeVariance, ErrsAtTheBoundaryNoMoreOftenThanAlpha) {
    std::mt19937_64 engine(9);
    for (const std::size_t n : {1000u, 2000u}) {
        const Verdicts boundary = verdicts(1500, [&] { return pareto_sample(2, n, engine); });
        EXPECT_TRUE(test::has_probability_at_most(boundary.infinite, 1500, 0.015, {.detects = 0.03}));
        EXPECT_TRUE(test::has_probability_at_most(boundary.finite, 1500, 0.015, {.detects = 0.03}));
    }
}

}  // namespace
}  // namespace ff::stats
