#include "core/radiosity/correlated_repair.hpp"

#include "core/radiosity/properties.hpp"
#include "tests/unit/core/radiosity/systems.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace ff {
namespace {

std::vector<Eigen::MatrixXd> multinomial(const Eigen::MatrixXd& factors, double rays) {
    std::vector<Eigen::MatrixXd> covariances;
    for (Eigen::Index i = 0; i < factors.rows(); ++i) {
        const Eigen::VectorXd p = factors.row(i);
        covariances.emplace_back(-p * p.transpose() / rays);
        covariances.back().diagonal() += p / rays;
    }
    return covariances;
}

// The generalised inverse of a multinomial covariance is diagonal, N / p: the other algorithm, with the same weights.
TEST(CorrelatedRepair, IsBalancingWhereCovariancesAreMultinomial) {
    const RadiositySystem box = test::lit_box();
    std::mt19937_64 engine(1);
    std::uniform_real_distribution<double> off(0.2, 1.8);
    for (int round = 0; round < 20; ++round) {
        Eigen::MatrixXd estimates = box.factors.unaryExpr([&](double factor) { return factor * off(engine); });
        estimates = normalise_rows(estimates);
        const Eigen::MatrixXd weights =
            box.factors.unaryExpr([](double factor) { return factor > 0 ? 100 / factor : 0.0; });
        const Balanced expected = balance(estimates, weights, box.areas);
        const Balanced found =
            balance_correlated(estimates, multinomial(box.factors, 100), box.areas, all_but_itself(6));
        ASSERT_TRUE(expected.balanced && found.balanced);
        EXPECT_LT((found.factors - expected.factors).cwiseAbs().maxCoeff(), 1e-9);
        EXPECT_GE(found.factors.minCoeff(), 0);
        EXPECT_NEAR(found.chi_squared / expected.chi_squared, 1, 1e-6);
    }
}

TEST(CorrelatedRepair, KeepsWhatIsRightAndFindsNothingWhereNothingIs) {
    const RadiositySystem box = test::lit_box();
    const Balanced same = balance_correlated(box.factors, multinomial(box.factors, 10), box.areas, all_but_itself(6));
    EXPECT_LT((same.factors - box.factors).cwiseAbs().maxCoeff(), 1e-12);
    const Eigen::VectorXd areas = Eigen::Vector3d(10, 1, 1);
    Eigen::MatrixXd estimates(3, 3);
    estimates << 0, 0.5, 0.5, 0.9, 0, 0.1, 0.9, 0.1, 0;
    EXPECT_FALSE(balance_correlated(estimates, multinomial(estimates, 10), areas, all_but_itself(3)).balanced);
}

// Errors that are opposite in two factors of a row cancel in their sum, and one way is far noisier than the other: a
// method that knows both has less left than one that takes the errors for those of counted hits.
TEST(CorrelatedRepair, UsesTheCovarianceOfTheSampler) {
    const Eigen::MatrixXd exact = test::lit_cube(0).factors;
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(6);
    std::mt19937_64 engine(2);
    std::normal_distribution<double> normal;
    std::vector<Eigen::MatrixXd> covariances;
    for (Eigen::Index i = 0; i < 6; ++i) {
        const double noise = i < 3 ? 1e-3 : 1e-2;
        covariances.emplace_back(noise * noise *
                                 (Eigen::MatrixXd::Identity(6, 6) - Eigen::MatrixXd::Constant(6, 6, 1.0 / 6)));
    }
    double known = 0;
    double taken_for_hits = 0;
    for (int trial = 0; trial < 200; ++trial) {
        Eigen::MatrixXd estimates = exact;
        for (Eigen::Index i = 0; i < 6; ++i) {
            Eigen::VectorXd error(6);
            for (double& e : error) e = (i < 3 ? 1e-3 : 1e-2) * normal(engine);
            estimates.row(i) += (error.array() - error.mean()).matrix();
        }
        known += (balance_correlated(estimates, covariances, ones, all_but_itself(6)).factors - exact).squaredNorm();
        const Eigen::MatrixXd weights =
            weights_of_hits(exact, Eigen::VectorXd::Constant(6, 1000), ones, all_but_itself(6));
        taken_for_hits += (balance(estimates, weights, ones).factors - exact).squaredNorm();
    }
    EXPECT_LT(known, 0.7 * taken_for_hits);
}

TEST(CovarianceOfRow, KeepsPairsWithoutHitsUncertain) {
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(40, 4);
    for (Eigen::Index t = 0; t < 40; ++t) {
        const double error = t % 2 == 0 ? 0 : 0.01;
        rows.row(t) << 0, 0.5 + error, 0.5 - error, 0;
    }
    const auto sight = (Eigen::Array<bool, Eigen::Dynamic, 1>(4) << false, true, true, true).finished();
    const Eigen::MatrixXd covariance = covariance_of_row(scatter_of_row(rows), sight, 1e-3);
    EXPECT_GT(covariance(3, 3), 0);
    EXPECT_EQ(covariance_of_row(scatter_of_row(rows), sight, 0)(3, 3), 0) << "what it would be without half a hit";
    EXPECT_EQ(covariance(0, 0), 0) << "without sight";
    EXPECT_LT((covariance * Eigen::VectorXd::Ones(4)).cwiseAbs().maxCoeff(), 1e-15) << "rows sum to 1";
}

// Many trials: the sample covariance itself, by two seconds' arithmetic (n - 1) / n of it and the rest drawn.
TEST(CovarianceOfRow, TendsToThatOfTheTrials) {
    std::mt19937_64 engine(3);
    std::normal_distribution<double> normal;
    Eigen::MatrixXd rows(4000, 3);
    for (Eigen::Index t = 0; t < rows.rows(); ++t) {
        const double e = 0.01 * normal(engine);
        rows.row(t) << 0.2 + e, 0.3 - e, 0.5;
    }
    const auto sight = Eigen::Array<bool, Eigen::Dynamic, 1>::Constant(3, true).eval();
    const Eigen::MatrixXd covariance = covariance_of_row(scatter_of_row(rows), sight, 0);
    EXPECT_NEAR(covariance(0, 1) / covariance(0, 0), -1, 0.01);
    EXPECT_NEAR(covariance(0, 0), 1e-4, 1e-4 * 6 * std::sqrt(2.0 / 4000)) << "six standard errors of a variance";
}

TEST(RowScatter, WithoutATrialIsThatOfTheOthers) {
    const Eigen::MatrixXd rows = Eigen::MatrixXd::Random(9, 4);
    const RowScatter left_out = without(scatter_of_row(rows), rows.row(8));
    const RowScatter others = scatter_of_row(rows.topRows(8));
    EXPECT_EQ(left_out.trials, 8);
    EXPECT_TRUE(left_out.mean.isApprox(others.mean, 1e-13));
    EXPECT_TRUE(left_out.scatter.isApprox(others.scatter, 1e-12));
}

}  // namespace
}  // namespace ff
