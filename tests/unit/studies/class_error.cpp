#include "studies/class_error.hpp"

#include "core/box.hpp"
#include "core/exact.hpp"

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
    Scene cube = make_box(1, 1, 1);
    Eigen::MatrixXd exact = *exact_form_factors(cube);
};

TEST_F(ClassErrors, AreRootMeanSquaresOverTrialsAndPairs) {
    const auto error =
        class_error(shifted(exact, {0.03, -0.04}), cube, exact, PairClass::parallel, VarianceStatus::finite, 0.95);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->pairs, 6u);
    EXPECT_NEAR(error->rmse, std::sqrt((0.0009 + 0.0016) / 2), 1e-12);
    ASSERT_TRUE(error->efficiency);
    EXPECT_NEAR(*error->efficiency, 1 / (0.00125 * 100), 1e-9);
}

TEST_F(ClassErrors, HaveTheIntervalOfTheMeanOverTrials) {
    const auto error = class_error(shifted(exact, {1e-3, 2e-3, 3e-3, 4e-3}), cube, exact, PairClass::adjacent,
                                   VarianceStatus::finite, 0.5);
    ASSERT_TRUE(error && error->interval);
    // Student t of the squares 1, 4, 9, 16: qt(0.75, 3) * sd / sqrt(4) in R's words.
    const double reach = 0.7648923284 * std::sqrt(129.0 / 3 / 4);
    EXPECT_NEAR(error->interval->low, 1e-3 * std::sqrt(7.5 - reach), 1e-9);
    EXPECT_NEAR(error->interval->high, 1e-3 * std::sqrt(7.5 + reach), 1e-9);
    ASSERT_TRUE(error->efficiency_interval);
    EXPECT_NEAR(error->efficiency_interval->low * error->interval->high * error->interval->high, 0.01, 1e-9);
}

TEST_F(ClassErrors, HaveNoIntervalWhereNoneHolds) {
    const auto estimates = shifted(exact, {0.01, 0.02, 0.03});
    for (const VarianceStatus status : {VarianceStatus::infinite, VarianceStatus::none}) {
        const auto error = class_error(estimates, cube, exact, PairClass::adjacent, status, 0.95);
        ASSERT_TRUE(error);
        EXPECT_FALSE(error->interval);
        EXPECT_FALSE(error->efficiency);
    }
    const auto one =
        class_error(shifted(exact, {0.01}), cube, exact, PairClass::adjacent, VarianceStatus::finite, 0.95);
    ASSERT_TRUE(one);
    EXPECT_FALSE(one->interval);
}

TEST_F(ClassErrors, AreEmptyWhereTheSceneHasNoSuchPair) {
    EXPECT_FALSE(class_error(shifted(exact, {0.01}), cube, exact, PairClass::other, VarianceStatus::finite, 0.95));
}

}  // namespace
}  // namespace ff::studies
