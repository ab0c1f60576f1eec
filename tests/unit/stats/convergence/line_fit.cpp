#include "stats/convergence/line_fit.hpp"

#include "tests/support/statistical_assertions.hpp"
#include "tests/unit/stats/samples.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace ff::stats {
namespace {

constexpr std::array line_x{1.0, 2.0, 3.0, 5.0};
constexpr std::array line_y{2.1, 3.9, 6.2, 9.8};
constexpr std::array line_variances{0.1, 0.2, 0.1, 0.4};

// W = np.diag(1/v); A = np.c_[np.ones(4), x]; c = np.linalg.inv(A.T@W@A); b = c@A.T@W@y
// r = y - A@b; q = r@W@r; b, c, q, chi2.sf(q, 2)
TEST(FitLine, AgreesWithNumpy) {
    const auto fit = fit_line(line_x, line_y, line_variances);
    EXPECT_NEAR(fit->intercept, 0.13146067415730478, 1e-13);
    EXPECT_NEAR(fit->slope, 1.974157303370786, 1e-13);
    EXPECT_NEAR(fit->variance_slope, 0.02471910112359551, 1e-14);
    EXPECT_NEAR(fit->chi_squared, 0.47752808988764117, 1e-13);
    EXPECT_NEAR(*fit->lack_of_fit_p, 0.7876006988167973, 1e-13);
    EXPECT_EQ(fit->freedom, 2u);
    EXPECT_NEAR(slope_interval_normal(*fit, 0.95).low, 1.666005702610923, 1e-12);
}

TEST(FitLine, NeedsTwoDistinctPlaces) {
    EXPECT_FALSE(fit_line({}, {}, {}));
    EXPECT_FALSE(fit_line(std::array{1.0}, std::array{1.0}, std::array{1.0}));
    EXPECT_FALSE(fit_line(std::array{3.0, 3.0}, std::array{1.0, 2.0}, std::array{1.0, 1.0}));
    const auto fit = fit_line(std::array{3.0, 4.0}, std::array{1.0, 3.0}, std::array{1.0, 1.0});
    EXPECT_DOUBLE_EQ(fit->slope, 2);
    EXPECT_FALSE(fit->lack_of_fit_p);
}

TEST(FitLine, SurvivesAHugeOffset) {
    const std::array far{1e8 + 1, 1e8 + 2, 1e8 + 3, 1e8 + 5};
    EXPECT_NEAR(fit_line(far, line_y, line_variances)->slope, 1.974157303370786, 1e-12);
}

// Risks: 1e-6; coverage off by .017 is noticed with power .99.
TEST(SlopeIntervals, CoverAtTheirLevelAndLackOfFitSeesACurve) {
    std::mt19937_64 engine(1);
    std::uint64_t normal = 0, false_alarms = 0, curves_found = 0;
    for (int run = 0; run < 10'000; ++run) {
        const auto noise = test::normal_sample(4, engine);
        std::array<double, 4> line{};
        std::array<double, 4> curve{};
        for (std::size_t i = 0; i < 4; ++i) {
            line[i] = 1 - 0.5 * line_x[i] + std::sqrt(line_variances[i]) * noise[i];
            curve[i] = line[i] + 0.6 * line_x[i] * line_x[i];
        }
        const auto fit = fit_line(line_x, line, line_variances);
        normal += slope_interval_normal(*fit, 0.95).contains(-0.5) ? 1u : 0u;
        false_alarms += *fit->lack_of_fit_p < 0.05 ? 1u : 0u;
        curves_found += *fit_line(line_x, curve, line_variances)->lack_of_fit_p < 0.05 ? 1u : 0u;
    }
    EXPECT_TRUE(test::has_probability(normal, 10'000, 0.95, {.detects = 0.017}));
    EXPECT_TRUE(test::has_probability(false_alarms, 10'000, 0.05, {.detects = 0.017}));
    EXPECT_TRUE(test::has_probability_at_least(curves_found, 10'000, 0.9, {.detects = 0.03}));
}

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
