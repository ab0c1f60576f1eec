#include "studies/theory/sr_distribution.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/exact/exact.hpp"
#include "tests/support/gridded_rooms.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace ff::studies {
namespace {

SrDistribution table4(Completion completion) {
    return sr_distribution(built_in_scene("cube"), Subdivision{13}, 625, completion).value();
}

/// Face numbers of the paper are one more than indices.
Eigen::Index entry(int i, int j) {
    return (i - 1) * 6 + j - 1;
}

// Expected figures: standard deviations over 10^5 simulated trials, rounded; the tolerance is their last digit.

TEST(SrDistribution, HasTheKnownSigmaOfPairs) {
    for (const Completion completion : {Completion::direct, Completion::reciprocal}) {
        const SrDistribution d = table4(completion);
        EXPECT_NEAR(d.pair_sigma(0, 5), 1.228e-3, 5e-7);
        EXPECT_NEAR(d.pair_sigma(0, 1), 1.177e-3, 5e-7);
        EXPECT_NEAR(d.pair_sigma(5, 0), 1.228e-3, 5e-7);
    }
}

TEST(SrDistribution, HasTheKnownSigmaOfReciprocalRowSums) {
    const SrDistribution d = table4(Completion::reciprocal);
    constexpr std::array<double, 6> expected{0, 1.67e-3, 2.24e-3, 2.51e-3, 2.66e-3, 2.66e-3};
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(d.sum_sigma(i), expected[static_cast<std::size_t>(i)], 5.1e-6) << i;
}

TEST(SrDistribution, HasNegativelyCorrelatedPairsOfOneFace) {
    const SrDistribution d = table4(Completion::reciprocal);
    for (int j = 2; j <= 6; ++j) {
        for (int k = j + 1; k <= 6; ++k) {
            const double correlation =
                d.pair_covariance(entry(1, j), entry(1, k)) / (d.pair_sigma(0, j - 1) * d.pair_sigma(0, k - 1));
            EXPECT_GT(correlation, -0.305) << j << k;
            EXPECT_LT(correlation, -0.195) << j << k;
        }
    }
}

TEST(SrDistribution, HasIndependentRowsWithDirectCompletionOnly) {
    const SrDistribution direct = table4(Completion::direct);
    const SrDistribution reciprocal = table4(Completion::reciprocal);
    EXPECT_EQ(direct.pair_covariance(entry(1, 2), entry(2, 1)), 0);
    EXPECT_DOUBLE_EQ(reciprocal.pair_covariance(entry(1, 2), entry(2, 1)),
                     reciprocal.pair_covariance(entry(1, 2), entry(1, 2)));
}

TEST(SrDistribution, ClosesExactlyWithDirectCompletion) {
    const SrDistribution d = table4(Completion::direct);
    for (int i = 0; i < 6; ++i) EXPECT_EQ(d.sum_sigma(i), 0);
}

TEST(SrDistribution, AgreesWithTheFormulaForReciprocalRowSums) {
    // Var = (1/P^2) sum_p q_p (1 - q_p) / n + sum over j < k of Var F_jk, with q_p = sum over j > k of F_pj.
    const SrDistribution d = table4(Completion::reciprocal);
    double variance = 0;  // of the last row, which has no rays of its own
    for (int j = 0; j < 5; ++j) variance += std::pow(d.pair_sigma(j, 5), 2);
    EXPECT_NEAR(d.sum_sigma(5), std::sqrt(variance), 1e-15);
}

TEST(SrDistribution, IsLessThanBinomial) {
    const double f = 0.199824896;
    EXPECT_LT(table4(Completion::direct).pair_sigma(0, 5), std::sqrt(f * (1 - f) / 105625));
}

TEST(SrDistribution, WeighsSurfacesOfAFaceByArea) {
    const Scene room = test::room_with_divided_floor();
    const SrDistribution d = sr_distribution(room, Subdivision{2}, 100, Completion::direct).value();
    const Eigen::MatrixXd exact = exact_form_factors(room).value();
    EXPECT_LT((d.mean - exact).cwiseAbs().maxCoeff(), 1e-14);
    for (int i = 0; i < 6; ++i) EXPECT_EQ(d.sum_sigma(i), 0);
    // From the patches: Var F_1j = sum over them of a_p^2 F_pj (1 - F_pj) / n, those of the smaller surface first.
    const Eigen::MatrixXd patches = exact_patch_to_face(room, {2}).value();
    double variance = 0;
    for (int p = 0; p < 8; ++p) variance += std::pow(0.25 / 8, 2) * patches(p, 3) * (1 - patches(p, 3)) / 100;
    for (Eigen::Index p = patches.rows() - 12; p < patches.rows(); ++p)
        variance += std::pow(0.75 / 12, 2) * patches(p, 3) * (1 - patches(p, 3)) / 100;
    EXPECT_NEAR(d.pair_sigma(0, 3), std::sqrt(variance), 1e-15);
}

TEST(SrDistribution, ScalesReciprocalEntriesByAreas) {
    const Scene box = built_in_scene("box:2x1x0.5");
    const SrDistribution d = sr_distribution(box, Subdivision{3}, 100, Completion::reciprocal).value();
    // Faces 1 (2 x 1) and 2 (2 x 0.5).
    EXPECT_NEAR(d.pair_sigma(1, 0), 2 * d.pair_sigma(0, 1), 1e-15);
}

}  // namespace
}  // namespace ff::studies
