#include "stats/convergence/power_law.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace ff::stats {
namespace {

// Closure errors of 5-node Gauss-Legendre at 6, 9 and 13 patches along an edge: 0.308 / m.
constexpr std::array closure_sizes{6.0, 9.0, 13.0};
constexpr std::array closure_errors{0.051365, 0.034243, 0.023707};

TEST(PowerLaw, RecoversTheCoefficientAtAFixedExponent) {
    const auto law = fit_power_law(closure_sizes, closure_errors, 1);
    EXPECT_NEAR(law->coefficient, (6 * 0.051365 + 9 * 0.034243 + 13 * 0.023707) / 3, 1e-15);
    EXPECT_NEAR(law->coefficient, 0.308, 5e-4);
    EXPECT_LT(law->largest_residual, 3e-5);  // half a unit of the last digit is 2e-5 of the smallest error
}

TEST(PowerLaw, RecoversTheExponentToo) {
    const auto law = fit_power_law(closure_sizes, closure_errors);
    EXPECT_NEAR(law->exponent, 1, 1e-4);
    EXPECT_NEAR(law->coefficient, 0.308, 1e-3);
    std::array<double, 3> exact{};
    for (std::size_t i = 0; i < 3; ++i) exact[i] = -2.5 * std::pow(closure_sizes[i], -1.7);
    EXPECT_NEAR(fit_power_law(closure_sizes, exact)->coefficient, -2.5, 1e-12);
    EXPECT_NEAR(fit_power_law(closure_sizes, exact)->exponent, 1.7, 1e-12);
}

TEST(PowerLaw, HasLargeResidualsForAWrongLaw) {
    std::array<double, 3> quadratic{};
    for (std::size_t i = 0; i < 3; ++i) quadratic[i] = 1 / (closure_sizes[i] * closure_sizes[i]);
    EXPECT_GT(fit_power_law(closure_sizes, quadratic, 1)->largest_residual, 0.3);
}

TEST(PowerLaw, IsEmptyWithoutEnoughOrWithMixedSigns) {
    EXPECT_FALSE(fit_power_law(std::array{6.0}, std::array{0.1}));
    EXPECT_TRUE(fit_power_law(std::array{6.0}, std::array{0.1}, 1));
    EXPECT_FALSE(fit_power_law(closure_sizes, std::array{0.1, -0.1, 0.05}));
    EXPECT_FALSE(fit_power_law(closure_sizes, std::array{0.0, 0.0, 0.0}));
    EXPECT_FALSE(fit_power_law(closure_sizes, std::array{0.0, 0.0, 0.0}, 1));
    EXPECT_FALSE(fit_power_law({}, {}));
    EXPECT_FALSE(fit_power_law({}, {}, 1));
}

}  // namespace
}  // namespace ff::stats
