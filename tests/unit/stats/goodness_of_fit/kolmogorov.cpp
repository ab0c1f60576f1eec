#include "tests/support/kolmogorov.hpp"

#include "stats/goodness_of_fit/anderson_darling.hpp"
#include "tests/support/statistical_assertions.hpp"
#include "tests/unit/stats/samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ff::stats {
namespace {

// from scipy.stats import _ksstats; _ksstats._kolmogn_Pomeranz(n, d, False): exact, by another algorithm
TEST(KolmogorovTail, IsExactUpToTwoThousand) {
    const auto close = [](std::size_t n, double d, double expected) {
        EXPECT_NEAR(test::kolmogorov_tail(n, d) / expected, 1, 1e-9) << n << ' ' << d;
    };
    close(1, 0.7, 0.6);
    close(5, 0.15, 0.9988);
    close(10, 0.3, 0.27053557479999946);
    close(10, 0.6, 0.0005681672);
    close(30, 0.1, 0.8960782680050898);
    close(100, 0.05, 0.9532159710635725);
    close(100, 0.1, 0.2526927570063874);
    close(500, 0.08, 0.0031305058091429378);
    close(1000, 0.03, 0.32269024641329315);
    close(2000, 0.02, 0.3953133720030792);
}

// from scipy.stats import kstwo; kstwo.sf(d, n)
TEST(KolmogorovTail, AgreesWithScipyInTheFarTail) {
    EXPECT_NEAR(test::kolmogorov_tail(1000, 0.1) / 3.703687096817711e-09, 1, 1e-9);
    EXPECT_NEAR(test::kolmogorov_tail(5000, 0.05) / 2.6523052328711187e-11, 1, 1e-9);
}

TEST(KolmogorovTail, IsAsymptoticBeyondTwoThousand) {
    EXPECT_NEAR(test::kolmogorov_tail(5000, 0.01), 0.6954557253913853, 1e-5);
    EXPECT_NEAR(test::kolmogorov_tail(2001, 0.02), test::kolmogorov_tail(2000, 0.02), 5e-4);
    EXPECT_NEAR(test::kolmogorov_tail(1'000'000, 0.001), 0.27, 1e-3);  // limiting law at z = 1
}

TEST(KolmogorovTail, IsOneAndZeroAtTheEnds) {
    EXPECT_EQ(test::kolmogorov_tail(10, 0.05), 1);  // no sample of 10 comes closer
    EXPECT_EQ(test::kolmogorov_tail(10, 1), 0);
}

// from scipy.stats import kstest; kstest([.1, .15, .4, .43, .7, .71, .95], 'uniform')
TEST(UniformityTest, AgreesWithScipy) {
    const auto test = test::test_uniformity(std::array{0.7, 0.1, 0.15, 0.4, 0.43, 0.71, 0.95});
    EXPECT_NEAR(test->distance, 0.14714285714285713, 1e-15);
    EXPECT_NEAR(test->p, 0.9913955323659152, 1e-10);
    EXPECT_FALSE(test::test_uniformity({}));
}

// Risks: 1e-6; a level off by .016 is noticed with power .99.
TEST(UniformityTest, RejectsUniformValuesAtItsLevelAndFindsSquaredOnes) {
    std::mt19937_64 engine(1);
    std::uint64_t false_alarms = 0;
    std::uint64_t found = 0;
    for (int i = 0; i < 12'000; ++i) {
        auto values = test::sample(std::uniform_real_distribution<double>(), 40, engine);
        false_alarms += test::test_uniformity(values)->p < 0.05 ? 1u : 0u;
        for (double& value : values) value *= value;
        found += test::test_uniformity(values)->p < 0.05 ? 1u : 0u;
    }
    EXPECT_TRUE(test::has_probability(false_alarms, 12'000, 0.05, {.detects = 0.016}));
    EXPECT_TRUE(test::has_probability_at_least(found, 12'000, 0.8, {.detects = 0.03}));
}

// np.sqrt(np.log(2/.05)/2000)
TEST(DkwBand, HasMassartsWidth) {
    EXPECT_NEAR(dkw_half_width(1000, 0.95), 0.04294694083467376, 1e-15);
}

// Coverage = 1 - P(D_n > half width) exactly, for continuous data.
TEST(DkwBand, CoversAtItsLevelForEverySize) {
    for (const std::size_t n : {1u, 2u, 10u, 100u, 1000u}) {
        const double missed = test::kolmogorov_tail(n, dkw_half_width(n, 0.95));
        EXPECT_LE(missed, 0.05);
        if (n >= 100) {
            EXPECT_GT(missed, 0.04);
        }
    }
}

}  // namespace
}  // namespace ff::stats
