#include "core/radiosity/repair.hpp"

#include "core/radiosity/system.hpp"
#include "tests/unit/core/radiosity/systems.hpp"

#include <gtest/gtest.h>

#include <random>

namespace ff {
namespace {

Eigen::MatrixXd squared_errors(const Eigen::MatrixXd& factors) {
    return (factors - test::lit_cube(0).factors).cwiseAbs2();
}

struct BalancedRoom {
    Eigen::MatrixXd factors;
    bool balanced = false;
};

BalancedRoom balance(const Eigen::MatrixXd& estimates, const Eigen::MatrixXd& weights, const Eigen::VectorXd& areas) {
    const Balanced result = ff::balance(estimates.sparseView(), weights.sparseView(), areas);
    return {Eigen::MatrixXd(result.factors), result.balanced};
}

/// Weights for a room with six equal faces, each of which emits `rays` rays.
Eigen::MatrixXd hit_weights(const Eigen::MatrixXd& estimates, double rays) {
    return weights_of_hits(estimates, Eigen::VectorXd::Constant(6, rays), Eigen::VectorXd::Ones(6), all_but_itself(6));
}

TEST(NormalisedRows, SumToOne) {
    const Eigen::MatrixXd factors = test::mirrored(test::shot_factors(100, 1));
    const FactorProperties properties = factor_properties(normalise_rows(factors), test::lit_cube(0).areas);
    EXPECT_LT(properties.closure_defect, 1e-15);
    EXPECT_GT(properties.reciprocity_defect, 1e-3) << "closure by rows has its price";
    EXPECT_EQ(normalise_rows(Eigen::MatrixXd::Zero(2, 2)), Eigen::MatrixXd::Zero(2, 2));
}

TEST(BalancedFactors, AreReciprocalClosedAndNonnegative) {
    const RadiositySystem box = test::lit_box();
    const Eigen::VectorXd rays = Eigen::VectorXd::Constant(6, 30);
    std::mt19937_64 engine(1);
    std::uniform_real_distribution<double> off(0, 2);
    for (int round = 0; round < 50; ++round) {
        const Eigen::MatrixXd estimates = box.factors.unaryExpr([&](double factor) { return factor * off(engine); });
        for (const Eigen::MatrixXd& weights :
             {weights_of_hits(estimates, rays, box.areas, all_but_itself(6)), weights_of_values(estimates)}) {
            const BalancedRoom result = balance(estimates, weights, box.areas);
            ASSERT_TRUE(result.balanced);
            const FactorProperties properties = factor_properties(result.factors, box.areas);
            EXPECT_LT(properties.closure_defect, 1e-11);
            EXPECT_LT(properties.reciprocity_defect, 1e-13);
            EXPECT_GE(result.factors.minCoeff(), 0);
            EXPECT_EQ(result.factors.diagonal(), Eigen::VectorXd::Zero(6));
        }
    }
}

TEST(BalancedFactors, LeaveExactFactorsUnchanged) {
    const RadiositySystem box = test::lit_box();
    const BalancedRoom result = balance(box.factors, weights_of_values(box.factors), box.areas);
    EXPECT_LT((result.factors - box.factors).cwiseAbs().maxCoeff(), 1e-13);
}

// No other reciprocal, closed, nonnegative matrix is nearer: small steps that keep the constraints only lead away.
TEST(BalancedFactors, AreTheLeastSquaresSolution) {
    const Eigen::MatrixXd estimates = test::shot_factors(12, 2);  // some pairs without a hit
    ASSERT_GT((estimates.array() == 0).count(), 6);
    const Eigen::VectorXd areas = Eigen::VectorXd::Ones(6);
    const Eigen::MatrixXd weights = hit_weights(estimates, 12);
    const BalancedRoom result = balance(estimates, weights, areas);
    ASSERT_TRUE(result.balanced);
    const auto cost = [&](const Eigen::MatrixXd& f) { return weights.cwiseProduct((f - estimates).cwiseAbs2()).sum(); };
    std::mt19937_64 engine(3);
    std::uniform_int_distribution<int> any(0, 5);
    int tried = 0;
    while (tried < 2000) {
        const int a = any(engine), b = any(engine), c = any(engine), d = any(engine);
        if (a == b || a == c || a == d || b == c || b == d || c == d) continue;
        Eigen::MatrixXd other = result.factors;
        const auto add = [&](int i, int j, double change) { other(i, j) += change, other(j, i) += change; };
        add(a, b, 1e-4), add(c, d, 1e-4), add(a, c, -1e-4), add(b, d, -1e-4);  // a cycle: row sums stay
        if (other.minCoeff() < 0) continue;
        EXPECT_GT(cost(other), cost(result.factors));
        ++tried;
    }
}

// A pair that was never hit need not be 0: it gets a share where the opposite direction and closure ask for it.
TEST(BalancedFactors, MayChangeAPairWithoutAHit) {
    Eigen::MatrixXd estimates = test::shot_factors(100, 5);
    estimates(0, 1) = 0;
    estimates(0, 2) = 1 - estimates.row(0).tail(3).sum();
    EXPECT_TRUE(hit_weights(estimates, 100).allFinite());
    const BalancedRoom result = balance(estimates, hit_weights(estimates, 100), Eigen::VectorXd::Ones(6));
    EXPECT_GT(result.factors(0, 1), 0.001);
}

// Two data for each pair and six constraints reduce the error: in theory to half of the variance, less what closure
// removes.
TEST(BalancedFactors, AreBetterThanTheEstimates) {
    double before = 0;
    double after = 0;
    double normalised = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const Eigen::MatrixXd estimates = test::shot_factors(1000, seed);
        const Eigen::MatrixXd weights = hit_weights(estimates, 1000);
        before += squared_errors(estimates).sum();
        after += squared_errors(balance(estimates, weights, Eigen::VectorXd::Ones(6)).factors).sum();
        normalised += squared_errors(normalise_rows(test::mirrored(estimates))).sum();
    }
    // 30 numbers with 24 degrees of freedom become 15 with 9: 0.375 of the squared error for equal variances. The ratio
    // of two sums over 200 matrices is known to sqrt(2 / (200 * 9)) = 3 %; six of these.
    EXPECT_NEAR(after / before, 9.0 / 24, 6 * 0.033 * 9 / 24);
    EXPECT_LT(after, normalised);
}

// Both directions estimate the same exchange area: with equal numbers of rays they weigh the same, however much their
// hits differ.
TEST(WeightsOfHits, AreTheSameBothWays) {
    const Eigen::MatrixXd weights = hit_weights(test::shot_factors(20, 4), 20);
    EXPECT_EQ(weights, weights.transpose());
    EXPECT_EQ(weights.diagonal(), Eigen::VectorXd::Zero(6));
    EXPECT_GT((weights + Eigen::MatrixXd::Identity(6, 6)).minCoeff(), 0);
    const Eigen::VectorXd areas = (Eigen::VectorXd(6) << 1, 1, 1, 1, 1, 4).finished();
    const Eigen::MatrixXd unequal = weights_of_hits(Eigen::MatrixXd::Constant(6, 6, 0.2),
                                                    Eigen::VectorXd::Constant(6, 20), areas, all_but_itself(6));
    EXPECT_NEAR(unequal(5, 0) / unequal(0, 5), 4, 1e-12) << "N / p, and p is a quarter from the large face";
}

// Patches of one plane see nothing of each other, and balancing must not invent any exchange between them.
TEST(BalancedFactors, StayZeroBetweenPatchesThatCannotSeeEachOther) {
    Sight sight = all_but_itself(6);
    sight(0, 1) = sight(1, 0) = false;
    Eigen::MatrixXd estimates = test::shot_factors(100, 5);
    estimates(0, 1) = estimates(1, 0) = 0;
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(6);
    const BalancedRoom result =
        balance(estimates, weights_of_hits(estimates, Eigen::VectorXd::Constant(6, 100), ones, sight), ones);
    ASSERT_TRUE(result.balanced);
    EXPECT_EQ(result.factors(0, 1), 0);
    EXPECT_EQ(result.factors(1, 0), 0);
    EXPECT_GT(balance(estimates, hit_weights(estimates, 100), ones).factors(0, 1), 0) << "broken on purpose";
}

TEST(BalancedFactors, AreEmptyWhereNoneExist) {
    const Eigen::VectorXd areas = Eigen::Vector3d(10, 1, 1);  // flat patches that cannot fill the view of the first
    Eigen::MatrixXd estimates(3, 3);
    estimates << 0, 0.5, 0.5, 0.9, 0, 0.1, 0.9, 0.1, 0;
    EXPECT_FALSE(balance(estimates, weights_of_values(estimates), areas).balanced);
}

}  // namespace
}  // namespace ff
