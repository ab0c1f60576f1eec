#include "stats/error_rates/multiplicity.hpp"

#include "stats/basics/distributions.hpp"
#include "tests/support/statistical_assertions.hpp"
#include "tests/unit/stats/samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace ff::stats {
namespace {

constexpr std::array p_values{0.01, 0.04, 0.03, 0.005, 0.5};

void expect_near(const std::vector<double>& actual, const std::vector<double>& expected) {
    ASSERT_EQ(actual.size(), expected.size());
    for (std::size_t i = 0; i < actual.size(); ++i) EXPECT_NEAR(actual[i], expected[i], 1e-14) << i;
}

// R: p <- c(.01, .04, .03, .005, .5); p.adjust(p, "holm"); 1 - (1 - p)^5
// (figures from the same formulas in numpy)
TEST(AdjustedPValues, AgreeWithR) {
    expect_near(holm(p_values), {0.04, 0.09, 0.09, 0.025, 0.5});
    expect_near(sidak(p_values), {0.0490099501, 0.1846273024, 0.1412659743, 0.024751246878125, 0.96875});
}

TEST(AdjustedPValues, AreUnchangedForOneOrNoTest) {
    const std::array one{0.3};
    for (const auto adjust : {holm, sidak}) {
        expect_near(adjust(one), {0.3});
        EXPECT_TRUE(adjust({}).empty());
        expect_near(adjust(std::array{1.0, 1.0}), {1, 1});
        expect_near(adjust(std::array{0.0, 1.0}), {0, 1});
    }
}

TEST(Sidak, KeepsTinyPValues) {
    EXPECT_NEAR(sidak(std::array{1e-30, 1.0})[0] / 2e-30, 1, 1e-12);
}

// -np.expm1(np.log1p(-1e-4)/30)
TEST(SidakLevel, IsALittleAboveBonferroni) {
    EXPECT_NEAR(sidak_level(1e-4, 30), 3.3334944550069565e-06, 1e-19);
    EXPECT_NEAR(bonferroni_level(1e-4, 30), 3.3333333333333333e-06, 1e-19);
    EXPECT_DOUBLE_EQ(sidak_level(0.05, 1), 0.05);
}

// Ten tests, two of them of false nulls at z = 5; wrong rejections among the other eight.
// Risks: 1e-6; a family-wise error rate above alpha by .012 is noticed with power .99.
TEST(Holm, KeepsTheFamilyWiseErrorRateThatUnadjustedTestsBreak) {
    std::mt19937_64 engine(1);
    constexpr std::uint64_t families = 20'000;
    std::uint64_t holm_errors = 0;
    std::uint64_t naive_errors = 0;
    for (std::uint64_t i = 0; i < families; ++i) {
        auto values = test::normal_sample(10, engine);
        values[8] += 5;
        values[9] += 5;
        for (double& value : values) value = normal_two_sided_p(value);
        const auto adjusted = holm(values);
        const auto wrong = [](double value) { return value <= 0.05; };
        holm_errors += std::any_of(adjusted.begin(), adjusted.begin() + 8, wrong) ? 1u : 0u;
        naive_errors += std::any_of(values.begin(), values.begin() + 8, wrong) ? 1u : 0u;
    }
    EXPECT_TRUE(test::has_probability_at_most(holm_errors, families, 0.05, {.detects = 0.012}));
    EXPECT_FALSE(test::has_probability_at_most(naive_errors, families, 0.05, {.detects = 0.012}));
}

}  // namespace
}  // namespace ff::stats
