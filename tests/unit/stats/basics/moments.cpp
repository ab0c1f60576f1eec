#include "stats/basics/moments.hpp"

#include "tests/unit/stats/samples.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace ff::stats {
namespace {

using test::eight_values;

// import numpy as np; from scipy import stats
// x = np.array([2.1, 3.4, 1.9, 5.6, 4.4, 2.8, 9.7, 3.3]); d = x - x.mean()
// x.mean(), x.var(ddof=1), stats.skew(x, bias=False), stats.kurtosis(x, bias=False), (d**4).sum()/(d**2).sum()**2 - 1/8
TEST(Moments, AgreeWithScipy) {
    const Moments moments = moments_of(eight_values, 3.0);
    EXPECT_EQ(moments.count(), 8u);
    EXPECT_NEAR(*moments.mean(), 4.15, 1e-14);
    EXPECT_NEAR(*moments.bias(), 1.15, 1e-14);
    EXPECT_NEAR(*moments.variance(), 6.477142857142856, 1e-13);
    EXPECT_NEAR(*moments.standard_error(), std::sqrt(6.477142857142856 / 8), 1e-14);
    EXPECT_NEAR(*moments.skewness(), 1.7391944916250794, 1e-13);
    EXPECT_NEAR(*moments.excess_kurtosis(), 3.2777978432425154, 1e-12);
    EXPECT_NEAR(*moments.variance_of_variance(), 0.3617736811453879, 1e-14);
    EXPECT_NEAR(*moments.mean_squared_error(), 1.15 * 1.15 + 6.477142857142856 * 7 / 8, 1e-13);
}

TEST(Moments, AreEmptyWhereUndefined) {
    Moments moments;
    EXPECT_FALSE(moments.mean() || moments.bias() || moments.mean_squared_error());
    moments.add(7);
    EXPECT_EQ(moments.mean(), 7);
    EXPECT_FALSE(moments.variance() || moments.standard_error() || moments.variance_of_variance());
    moments.add(8);
    EXPECT_EQ(moments.variance(), 0.5);
    EXPECT_FALSE(moments.skewness());
    moments.add(10);
    EXPECT_TRUE(moments.skewness());
    EXPECT_FALSE(moments.excess_kurtosis());
    moments.add(11);
    EXPECT_TRUE(moments.excess_kurtosis());
}

TEST(Moments, HaveZeroVarianceAndNoShapeForEqualValues) {
    const Moments moments = moments_of(std::array{0.1, 0.1, 0.1, 0.1, 0.1, 0.1}, 0.2);
    EXPECT_EQ(moments.variance(), 0);
    EXPECT_EQ(moments.bias(), 0.1 - 0.2);
    EXPECT_FALSE(moments.skewness() || moments.excess_kurtosis() || moments.variance_of_variance());
}

TEST(Moments, ResolveATinyVarianceAndBiasBesideAMeanOfAFifth) {
    // Values on the lattice of doubles near 0.2, so that the truth is known exactly: reference + k * 2^-40, k = 1,
    // 2, 3.
    const double reference = 0.2;
    Moments moments(reference);
    for (const double k : {1.0, 2.0, 3.0}) moments.add(reference + k * 0x1p-40);
    EXPECT_NEAR(*moments.variance() / 0x1p-80, 1, 1e-4);  // 2^-80 = 8e-25; rounding of 0.2 + k 2^-40 is 3e-5 of 2^-40
    EXPECT_NEAR(*moments.bias() / 0x1p-39, 1, 1e-4);
}

TEST(Moments, SurviveAHugeOffsetThatDefeatsSumsOfSquares) {
    double sum = 0;
    double sum_of_squares = 0;
    Moments moments(1e9);
    for (const double value : eight_values) {
        moments.add(1e9 + value);
        sum += 1e9 + value;
        sum_of_squares += (1e9 + value) * (1e9 + value);
    }
    EXPECT_NEAR(*moments.variance(), 6.477142857142856, 1e-6);
    EXPECT_NEAR(*moments.excess_kurtosis(), 3.2777978432425154, 1e-5);
    EXPECT_GT(std::abs((sum_of_squares - sum * sum / 8) / 7 - 6.477142857142856), 1);  // the textbook formula is lost
}

TEST(ShapeStandardErrors, AgreeWithSpssAndSas) {
    EXPECT_NEAR(*skewness_standard_error(20), 0.5121033367077574, 1e-14);
    EXPECT_NEAR(*excess_kurtosis_standard_error(20), 0.992383612541845, 1e-14);
    EXPECT_FALSE(skewness_standard_error(2) || excess_kurtosis_standard_error(3));
}

}  // namespace
}  // namespace ff::stats
