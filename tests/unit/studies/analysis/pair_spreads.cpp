#include "studies/analysis/pair_spreads.hpp"

#include "tests/support/statistical_assertions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

namespace ff::studies {
namespace {

constexpr std::size_t pairs_of_cube = 30;

/// Laws of standard deviation 1.
using Law = double (*)(std::mt19937_64&);

double normal(std::mt19937_64& engine) {
    return std::normal_distribution<double>()(engine);
}

double on_two_sides(std::mt19937_64& engine) {
    std::uniform_real_distribution<double> uniform;
    const double size = (1 + 0.3 * uniform(engine)) / std::sqrt(1.33);
    return uniform(engine) < 0.5 ? size : -size;
}

double log_normal(std::mt19937_64& engine) {
    constexpr double sigma = 0.7;
    const double variance = std::expm1(sigma * sigma) * std::exp(sigma * sigma);
    return (std::exp(sigma * normal(engine)) - std::exp(sigma * sigma / 2)) / std::sqrt(variance);
}

/// @param factor  of the first pair's standard deviation
PairSpreads spreads_of_trials(Law law, std::size_t trials, double factor, std::mt19937_64& engine) {
    std::vector<std::optional<stats::Measured>> logarithms;
    for (std::size_t i = 0; i < pairs_of_cube; ++i) {
        std::vector<double> values;
        while (values.size() < trials) values.push_back(law(engine) * (i == 0 ? factor : 1));
        const ClassError found = class_error_of(values, 1, 1, VarianceStatus::finite, 0.95);
        logarithms.push_back(found.squared_deviation ? std::optional(log_variance(found)) : std::nullopt);
    }
    return spreads_of(std::move(logarithms));
}

/// Comparisons in which some pair's standard deviations are found to differ, at 5 % over all tests of means and of
/// these.
std::uint64_t told_apart(Law first, Law second, std::size_t trials, int comparisons, double factor = 1) {
    std::mt19937_64 engine(trials);
    std::uint64_t found = 0;
    for (int comparison = 0; comparison < comparisons; ++comparison) {
        const PairSpreads a = spreads_of_trials(first, trials, 1, engine);
        const PairSpreads b = spreads_of_trials(second, trials, factor, engine);
        double least = 1;
        for (std::size_t i = 0; i < pairs_of_cube; ++i) {
            if (const auto both = compared_spreads(a, b, i))
                least = std::min(least, stats::p_of_equal((*both)[0], (*both)[1]));
        }
        found += least < 0.05 / (2 * pairs_of_cube) ? 1u : 0u;
    }
    return found;
}

// Risks: 1e-6 each; a rate of 30 %, where tests of distances from the median have 25 % to 99 %, is noticed with
// power .99.
TEST(PairSpreads, DoNotMistakeShapesForStandardDeviations) {
    for (const std::size_t trials : {20u, 100u}) {
        for (const auto& [first, second] :
             {std::pair<Law, Law>(log_normal, normal), {on_two_sides, normal}, {on_two_sides, log_normal}}) {
            EXPECT_TRUE(
                test::has_probability_at_most(told_apart(first, second, trials, 100), 100, 0.05, {.detects = 0.25}))
                << trials;
        }
    }
}

// A factor 2 on one of 30 pairs is found in four of five comparisons. Risks: 1e-6; a rate of 20 % is noticed with power
// .99.
TEST(PairSpreads, DetectADoubledStandardDeviation) {
    EXPECT_TRUE(test::has_probability_at_least(told_apart(normal, normal, 100, 100, 2), 100, 0.6, {.detects = 0.4}));
}

// A ratio that is said to be detectable is found in most comparisons. Risks: 1e-6; a rate of 40 % is noticed with power
// .99.
TEST(PairSpreads, DetectTheDetectableRatio) {
    constexpr double level = 1 - 0.05 / (2 * pairs_of_cube);
    std::mt19937_64 engine(1);
    const PairSpreads a = spreads_of_trials(normal, 100, 1, engine);
    const PairSpreads b = spreads_of_trials(normal, 100, 1, engine);
    std::vector<double> ratios;
    for (std::size_t i = 0; i < pairs_of_cube; ++i)
        ratios.push_back(detectable_ratio(*compared_spreads(a, b, i), level, 0.9));
    std::sort(ratios.begin(), ratios.end());
    const double ratio = ratios[pairs_of_cube / 2];
    EXPECT_TRUE(test::has_probability_at_least(told_apart(normal, normal, 100, 100, ratio), 100, 0.8, {.detects = 0.4}))
        << ratio;
    const PairSpreads few = spreads_of_trials(normal, 10, 1, engine);
    EXPECT_TRUE(std::isinf(detectable_ratio(*compared_spreads(few, few, 0), level, 0.9)));
}

}  // namespace
}  // namespace ff::studies
