#include "stats/goodness_of_fit/chi_squared.hpp"

#include "tests/support/kolmogorov.hpp"
#include "tests/support/statistical_assertions.hpp"
#include "tests/unit/stats/samples.hpp"

#include <gtest/gtest.h>
#include <Eigen/Cholesky>

#include <array>
#include <cmath>

namespace ff::stats {
namespace {

const std::array deviations{0.5, -0.2, 0.1};

Eigen::Matrix3d example_covariance() {
    Eigen::Matrix3d c;
    c << 1, .3, -.2, .3, .5, .1, -.2, .1, .25;
    return c;
}

// d = np.array([.5, -.2, .1]); C = np.array([[1, .3, -.2], [.3, .5, .1], [-.2, .1, .25]])
// s = d @ np.linalg.solve(C, d); s, chi2.sf(s, 3)
TEST(CombineDeviations, AgreesWithNumpy) {
    const auto test = combine_deviations(deviations, example_covariance());
    EXPECT_NEAR(test->chi_squared.statistic, 1.3165289256198347, 1e-13);
    EXPECT_NEAR(test->chi_squared.p, 0.7252119117068245, 1e-13);
    EXPECT_EQ(test->chi_squared.freedom, 3u);
    EXPECT_EQ(test->outside, 0);
}

TEST(CombineDeviations, DoesNotDependOnUnits) {
    const Eigen::Vector3d units(1, 1e-12, 1e6);
    const Eigen::Matrix3d scale = units.asDiagonal();
    const std::array scaled{0.5, -0.2e-12, 0.1e6};
    const auto test = combine_deviations(scaled, scale * example_covariance() * scale);
    EXPECT_EQ(test->chi_squared.freedom, 3u);
    EXPECT_NEAR(test->chi_squared.statistic, 1.3165289256198347, 1e-9);
}

/// Covariance of multinomial shares: singular, because the shares add up to 1.
Eigen::MatrixXd multinomial_covariance(const Eigen::VectorXd& p, double rays) {
    const Eigen::MatrixXd variances = p.asDiagonal();
    return (variances - p * p.transpose()) / rays;
}

TEST(CombineDeviations, EqualsPearsonsChiSquaredForASingularCovariance) {
    const Eigen::Vector4d p(0.2, 0.25, 0.25, 0.3);
    const std::array<std::uint64_t, 4> counts{18, 25, 30, 27};
    const std::array shares{-0.02, 0.0, 0.05, -0.03};
    const auto quadratic = combine_deviations(shares, multinomial_covariance(p, 100));
    const auto pearson = test_goodness_of_fit(counts, std::array{0.2, 0.25, 0.25, 0.3});
    EXPECT_EQ(quadratic->chi_squared.freedom, 3u);
    EXPECT_NEAR(quadratic->chi_squared.statistic, pearson->chi_squared.statistic, 1e-10);
    EXPECT_LT(quadratic->outside, 1e-15);
}

TEST(CombineDeviations, ReportsADeviationThatTheCovarianceExcludes) {
    const Eigen::Vector4d p(0.2, 0.25, 0.25, 0.3);
    const std::array not_closed{-0.02, 0.0, 0.05, -0.02};  // adds up to 0.01
    EXPECT_GT(combine_deviations(not_closed, multinomial_covariance(p, 100))->outside, 1e-3);
    Eigen::Matrix2d certain = Eigen::Matrix2d::Zero();
    certain(0, 0) = 1;
    EXPECT_EQ(combine_deviations(std::array{0.5, 0.25}, certain)->outside, 0.25);
    EXPECT_EQ(combine_deviations(std::array{0.5, 0.0}, certain)->outside, 0);
    EXPECT_EQ(combine_deviations(std::array{0.5, 0.0}, certain)->chi_squared.freedom, 1u);
    EXPECT_FALSE(combine_deviations(std::array{0.5, 0.0}, Eigen::Matrix2d::Zero()));
}

// p-values of correlated normal deviations are uniform; with the correlations left out they are not. Alarm: 1e-6.
TEST(CombineDeviations, GivesUniformPValuesOnlyWithTheCorrelations) {
    Eigen::Matrix3d covariance;
    covariance << 1, .8, .8, .8, 1, .8, .8, .8, 1;
    const Eigen::Matrix3d root = covariance.llt().matrixL();
    const Eigen::Matrix3d diagonal = covariance.diagonal().asDiagonal();
    std::mt19937_64 engine(1);
    std::vector<double> right;
    std::vector<double> wrong;
    for (int i = 0; i < 4000; ++i) {
        const auto z = test::normal_sample(3, engine);
        const Eigen::Vector3d d = root * Eigen::Vector3d(z[0], z[1], z[2]);
        const std::array values{d(0), d(1), d(2)};
        right.push_back(combine_deviations(values, covariance)->chi_squared.p);
        wrong.push_back(combine_deviations(values, diagonal)->chi_squared.p);
    }
    EXPECT_GT(test::test_uniformity(right)->p, 1e-6);
    EXPECT_LT(test::test_uniformity(wrong)->p, 1e-6);
}

// from scipy.stats import chisquare; chisquare([18, 25, 30, 27], [20, 25, 25, 30])
TEST(GoodnessOfFit, AgreesWithScipy) {
    const auto test =
        test_goodness_of_fit(std::array<std::uint64_t, 4>{18, 25, 30, 27}, std::array{0.2, 0.25, 0.25, 0.3});
    EXPECT_NEAR(test->chi_squared.statistic, 1.5, 1e-12);
    EXPECT_NEAR(test->chi_squared.p, 0.6822703303362125, 1e-12);
    EXPECT_EQ(test->cells, 4u);
}

TEST(GoodnessOfFit, PoolsRareCellsUntilEachExpectsEnough) {
    // Expectations 1, 2, 3, 44, 50: the first three make one cell of 6.
    const std::array<std::uint64_t, 5> counts{0, 4, 3, 40, 53};
    const auto test = test_goodness_of_fit(counts, std::array{0.01, 0.02, 0.03, 0.44, 0.5});
    EXPECT_EQ(test->cells, 3u);
    EXPECT_NEAR(test->chi_squared.statistic, 1.0 / 6 + 16.0 / 44 + 9.0 / 50, 1e-12);
    EXPECT_EQ(test->chi_squared.freedom, 2u);
}

TEST(GoodnessOfFit, KnowsImpossibleCountsAndTooFewCells) {
    const std::array<std::uint64_t, 3> counts{50, 49, 1};
    const auto test = test_goodness_of_fit(counts, std::array{0.5, 0.5, 0.0});
    EXPECT_TRUE(test->impossible);
    EXPECT_EQ(test->chi_squared.p, 0);
    EXPECT_FALSE(test_goodness_of_fit(std::array<std::uint64_t, 2>{3, 4}, std::array{0.5, 0.5}));
    EXPECT_FALSE(test_goodness_of_fit(std::array<std::uint64_t, 1>{100}, std::array{1.0}));
}

// Risks: 1e-6; a level off by .022 is noticed with power .99.
TEST(GoodnessOfFit, RejectsMultinomialCountsAtItsLevelAndFindsShiftedOnes) {
    std::mt19937_64 engine(2);
    const std::vector<double> p{0.2, 0.2, 0.2, 0.2, 0.2};
    const auto rejects = [&](std::discrete_distribution<std::size_t> law) {
        std::array<std::uint64_t, 5> counts{};
        for (int ray = 0; ray < 625; ++ray) ++counts[law(engine)];
        return test_goodness_of_fit(counts, p)->chi_squared.p < 0.05;
    };
    const auto false_alarms = test::count_events(6000, [&] { return rejects({1, 1, 1, 1, 1}); });
    const auto found = test::count_events(1000, [&] { return rejects({1.4, 0.9, 0.9, 0.9, 0.9}); });
    EXPECT_TRUE(test::has_probability(false_alarms, 6000, 0.05, {.detects = 0.022}));
    EXPECT_GT(found, 950u);
}

}  // namespace
}  // namespace ff::stats
