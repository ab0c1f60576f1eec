#include "studies/analysis/class_error.hpp"

#include "core/exact/exact.hpp"
#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"

#include <gtest/gtest.h>

namespace ff::studies {
namespace {

/// Estimates of a cube that are off by `errors[trial]` on every pair.
CellEstimates shifted(const Eigen::MatrixXd& exact, const std::vector<double>& errors) {
    CellEstimates estimates;
    estimates.faces = 6;
    estimates.evaluations_per_face = 100;
    estimates.factors.resize(36);
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = 0; j < 6; ++j) {
            if (i == j) continue;
            for (const double error : errors) {
                estimates.factors[i * 6 + j].push_back(exact(static_cast<int>(i), static_cast<int>(j)) + error);
            }
        }
    }
    estimates.row_sums.assign(6, std::vector<double>(errors.size(), 1.0));
    return estimates;
}

class ClassErrors : public testing::Test {
  protected:
    [[nodiscard]] std::optional<ClassError> of(const std::vector<double>& errors, PairClass pair_class,
                                               VarianceStatus status = VarianceStatus::finite,
                                               double level = 0.95) const {
        return class_error(shifted(exact, errors), cube, KnownFactors(exact), distinct_pairs(6, Completion::direct),
                           pair_class, status, level, [](Quantity) { return stats::Unmet{}; });
    }

    Scene cube = make_box(1, 1, 1);
    Eigen::MatrixXd exact = *exact_form_factors(cube);
};

TEST_F(ClassErrors, AreRootMeanSquaresOverTrialsAndPairs) {
    const auto error = of({0.03, -0.04}, PairClass::parallel);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->pairs, 6u);
    EXPECT_NEAR(error->rmse, std::sqrt((0.0009 + 0.0016) / 2), 1e-12);
    ASSERT_TRUE(error->efficiency);
    EXPECT_NEAR(*error->efficiency, 1 / (0.00125 * 100), 1e-9);
}

TEST_F(ClassErrors, HaveTheIntervalOfTheMeanOverTrials) {
    const auto error = of({1e-3, 2e-3, 3e-3, 4e-3, 5e-3}, PairClass::adjacent, VarianceStatus::finite, 0.5);
    ASSERT_TRUE(error && error->interval);
    const auto squares = stats::mean_interval(std::array{1e-6, 4e-6, 9e-6, 16e-6, 25e-6}, 0, 0.5);
    EXPECT_NEAR(error->interval->low, std::sqrt(squares->low), 1e-9);
    EXPECT_NEAR(error->interval->high, std::sqrt(squares->high), 1e-9);  // 24 pairs in 5 trials are more than 100
    ASSERT_TRUE(error->efficiency_interval);
    EXPECT_NEAR(error->efficiency_interval->low * error->interval->high * error->interval->high, 0.01, 1e-9);
}

TEST(FewSquares, MayAllLieBelowTheirMean) {
    const std::array errors{1e-3, 2e-3, 3e-3, 4e-3, 5e-3};
    const auto squares = stats::mean_interval(std::array{1e-6, 4e-6, 9e-6, 16e-6, 25e-6}, 0, 0.5);
    const auto error = class_error_of(errors, 1, 100, VarianceStatus::finite, 0.5);
    ASSERT_TRUE(error.interval);
    EXPECT_NEAR(error.interval->low, std::sqrt(squares->low), 1e-9);
    // Five of a hundred squares: as if the mean 11e-6 might be 20 times as large.
    EXPECT_NEAR(error.interval->high, std::sqrt(squares->high + 19 * 11e-6), 1e-9);
}

TEST_F(ClassErrors, HaveBiasAndVarianceOfTheTrials) {
    const auto error = of({1e-3, 2e-3, 3e-3, 4e-3, 5e-3}, PairClass::adjacent);
    ASSERT_TRUE(error && error->bias_interval && error->squared_deviation);
    EXPECT_NEAR(error->bias, 3e-3, 1e-12);
    EXPECT_NEAR(error->median_abs_error, 3e-3, 1e-12);
    EXPECT_NEAR(*error->variance, 2.5e-6, 1e-12);
    const double t = 2.7764451051977987;                                          // qt(0.975, 4)
    EXPECT_GT(error->bias_interval->width() / 2, 1e-3 * t * std::sqrt(2.5 / 5));  // five values may be skewed
    // Squared deviations 4, 1, 0, 1, 4 (times 1e-6): mean 2, standard error sqrt(14 / 4 / 5).
    EXPECT_NEAR(error->squared_deviation->difference, 2e-6, 1e-12);
    EXPECT_NEAR(error->squared_deviation->standard_error, 1e-6 * std::sqrt(14.0 / 4 / 5), 1e-12);
    EXPECT_FALSE(error->variance_interval);  // its lower end would be 0
}

TEST_F(ClassErrors, HaveASpreadButNoTestForFewHits) {
    const auto error = of({0.01, 0.02, 0.03}, PairClass::adjacent, VarianceStatus::sparse);
    ASSERT_TRUE(error);
    EXPECT_TRUE(error->variance);
    EXPECT_FALSE(error->interval);
    EXPECT_FALSE(error->bias_interval);
}

TEST_F(ClassErrors, HaveNoIntervalWithoutAFiniteVariance) {
    for (const VarianceStatus status : {VarianceStatus::infinite, VarianceStatus::none}) {
        const auto error = of({0.01, 0.02, 0.03}, PairClass::adjacent, status);
        ASSERT_TRUE(error);
        EXPECT_FALSE(error->interval);
        EXPECT_FALSE(error->bias_interval);
        EXPECT_FALSE(error->variance);
        EXPECT_FALSE(error->efficiency);
    }
    const auto one = of({0.01}, PairClass::adjacent);
    ASSERT_TRUE(one);
    EXPECT_FALSE(one->interval);
    EXPECT_FALSE(one->variance);
}

TEST_F(ClassErrors, AreEmptyWhereTheSceneHasNoSuchPair) {
    EXPECT_FALSE(of({0.01}, PairClass::other));
}

}  // namespace
}  // namespace ff::studies
