#include "stats/mean_difference.hpp"

#include <gtest/gtest.h>

#include <array>

namespace ff::stats {
namespace {

constexpr std::array first_sample{2.1, 3.4, 1.9, 5.6};
constexpr std::array second_sample{4.4, 2.8, 9.7, 3.3, 8.1};

// Python: va, vb = variance(a) / 4, variance(b) / 5 (statistics); t = (mean(b) - mean(a)) / sqrt(va + vb);
// df = (va + vb)**2 / (va**2 / 3 + vb**2 / 4); p = 1 - 2 * (Simpson's rule over Student's density from 0 to t, 200000
// steps)
TEST(MeanDifference, AgreesWithTheFormulas) {
    const auto test = test_means_welch(moments_of(first_sample, 3), moments_of(second_sample, 3));
    EXPECT_NEAR(test->difference, 2.41, 1e-14);
    EXPECT_NEAR(test->difference / test->standard_error, 1.4932503657627956, 1e-13);
    EXPECT_NEAR(test->freedom, 6.406989976675685, 1e-12);
    EXPECT_NEAR(test->p, 0.18289368648894733, 1e-12);
}

TEST(MeanDifference, KeepsItsDigitsFarFromZero) {
    std::array shifted = first_sample;
    for (double& value : shifted) value = 1e6 + value * 0x1p-20;
    std::array other = second_sample;
    for (double& value : other) value = 1e6 + value * 0x1p-20;
    const auto near = test_means_welch(moments_of(first_sample), moments_of(second_sample));
    const auto far = test_means_welch(moments_of(shifted, 1e6), moments_of(other, 1e6));
    EXPECT_NEAR(far->p, near->p, 1e-3);  // spacing of doubles near 10^6: 1e-10, in differences of 1e-6
}

TEST(MeanDifference, AcceptsAConstantSample) {
    const std::array constant{3.0, 3.0, 3.0};
    const auto test = test_means_welch(moments_of(constant), moments_of(second_sample));
    EXPECT_NEAR(test->freedom, 4, 1e-14);
}

TEST(MeanDifference, IsEmptyWithoutSpread) {
    const std::array constant{3.0, 3.0, 3.0};
    EXPECT_FALSE(test_means_welch(moments_of(constant), moments_of(constant)));
    EXPECT_FALSE(test_means_welch(moments_of(std::array{1.0}), moments_of(second_sample)));
}

}  // namespace
}  // namespace ff::stats
