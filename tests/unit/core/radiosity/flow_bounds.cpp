#include "core/radiosity/flow_bounds.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <random>
#include <vector>

namespace ff {
namespace {

using Eigen::Index;

Eigen::VectorXd irradiation(const Eigen::MatrixXd& factors, const FaceLaws& laws) {
    const Index n = factors.rows();
    const Eigen::MatrixXd between = factors.leftCols(n);
    const Eigen::MatrixXd system = Eigen::MatrixXd::Identity(n, n) - between * laws.reflected.asDiagonal();
    return system.partialPivLu().solve(between * laws.emitted + factors.col(n) * laws.surroundings);
}

struct RandomCase {
    Eigen::MatrixXd factors;
    Eigen::MatrixXd low;
    Eigen::MatrixXd high;
    FaceLaws laws;
};

/// Entries that may be above 0.
FactorBounds sparse(const Eigen::MatrixXd& low, const Eigen::MatrixXd& high) {
    std::vector<Eigen::Triplet<double>> lows;
    std::vector<Eigen::Triplet<double>> highs;
    for (Index i = 0; i < low.rows(); ++i) {
        for (Index j = 0; j < low.cols(); ++j) {
            if (high(i, j) == 0) continue;
            lows.emplace_back(i, j, low(i, j));
            highs.emplace_back(i, j, high(i, j));
        }
    }
    FactorBounds bounds{FactorBounds::Sparse(low.rows(), low.cols()), FactorBounds::Sparse(low.rows(), low.cols())};
    bounds.low.setFromTriplets(lows.begin(), lows.end());
    bounds.high.setFromTriplets(highs.begin(), highs.end());
    return bounds;
}

/// Random factors whose rows add up to 1, intervals around them, and faces of all kinds.
RandomCase random_case(std::mt19937_64& random, Index n, double width) {
    std::uniform_real_distribution<double> uniform(0, 1);
    RandomCase made;
    made.factors = Eigen::MatrixXd::NullaryExpr(n, n + 1, [&] { return uniform(random); });
    if (uniform(random) < 0.5) made.factors.col(n).setZero();
    for (Index i = 0; i < n; ++i) made.factors.row(i) /= made.factors.row(i).sum();
    made.low = made.high = made.factors;
    for (Index i = 0; i < n; ++i) {
        for (Index j = 0; j <= n; ++j) {
            made.low(i, j) = std::max(0.0, made.factors(i, j) - width * uniform(random));
            made.high(i, j) += width * uniform(random);
        }
    }
    made.laws.emitted = Eigen::VectorXd::NullaryExpr(n, [&] { return 4 * uniform(random) - 1; });
    made.laws.reflected =
        Eigen::VectorXd::NullaryExpr(n, [&] { return uniform(random) < 0.3 ? 1.0 : uniform(random); });
    made.laws.reflected[0] = 0.5;
    made.laws.surroundings = uniform(random);
    return made;
}

/// Another matrix within the intervals whose rows add up to 1: mass moved at random between pairs of columns.
Eigen::MatrixXd moved(const RandomCase& of, std::mt19937_64& random) {
    std::uniform_int_distribution<Index> any(0, of.factors.cols() - 1);
    std::uniform_real_distribution<double> uniform(0, 1);
    Eigen::MatrixXd factors = of.factors;
    for (Index i = 0; i < factors.rows(); ++i) {
        for (Index k = 0; k < 4 * factors.cols(); ++k) {
            const Index from = any(random);
            const Index to = any(random);
            const double most = std::min(factors(i, from) - of.low(i, from), of.high(i, to) - factors(i, to));
            const double share = uniform(random) < 0.5 ? most : most * uniform(random);
            factors(i, from) -= share;
            factors(i, to) += share;
        }
    }
    return factors;
}

TEST(FlowBounds, HoldForEveryMatrixWithinTheIntervals) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 300; ++i) {
        const RandomCase made = random_case(random, 2 + i % 7, i % 3 == 0 ? 1e-4 : 0.1);
        const auto bounds = bound_irradiation(sparse(made.low, made.high), made.laws);
        for (int k = 0; k < 20; ++k) {
            const Eigen::VectorXd h = irradiation(k == 0 ? made.factors : moved(made, random), made.laws);
            EXPECT_TRUE((h.array() >= bounds.low.array()).all() && (h.array() <= bounds.high.array()).all()) << i;
        }
    }
}

// Bounds that are merely wide would hold as well: the best of many random matrices comes close to these.
TEST(FlowBounds, AreNearlyAttained) {
    std::mt19937_64 random(2);
    const RandomCase made = random_case(random, 2, 0.05);
    const auto bounds = bound_irradiation(sparse(made.low, made.high), made.laws);
    Eigen::VectorXd least = irradiation(made.factors, made.laws);
    Eigen::VectorXd most = least;
    for (int k = 0; k < 5000; ++k) {
        const Eigen::VectorXd h = irradiation(moved(made, random), made.laws);
        least = least.cwiseMin(h);
        most = most.cwiseMax(h);
    }
    for (Index i = 0; i < 2; ++i) EXPECT_GE(most[i] - least[i], 0.99 * (bounds.high[i] - bounds.low[i])) << i;
}

TEST(FlowBounds, EqualTheSolutionForExactFactors) {
    std::mt19937_64 random(3);
    const RandomCase made = random_case(random, 6, 0);
    const auto bounds = bound_irradiation(sparse(made.factors, made.factors), made.laws);
    const Eigen::VectorXd h = irradiation(made.factors, made.laws);
    EXPECT_LT((bounds.high - h).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_LT((bounds.low - h).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(FlowBounds, NeedAFaceThatAbsorbs) {
    Eigen::MatrixXd low = Eigen::MatrixXd::Zero(3, 4);
    low(0, 1) = low(1, 0) = low(2, 2) = 1;
    Eigen::MatrixXd high = low;
    FaceLaws laws{Eigen::VectorXd::Ones(3), Eigen::VectorXd::Ones(3), 0};
    laws.reflected[0] = 0.5;
    const auto cut_off = find_absorption(sparse(low, high), laws);
    EXPECT_EQ(cut_off.absorption, Absorption::not_reached);
    EXPECT_EQ(cut_off.face, 2);
    high(2, 0) = 0.1;
    EXPECT_EQ(find_absorption(sparse(low, high), laws).absorption, Absorption::unresolved);
    low(2, 0) = 0.1;
    low(2, 2) = 0.9;
    EXPECT_EQ(find_absorption(sparse(low, high), laws).absorption, Absorption::reached);
}

// Nearly everything is reflected hundreds of times before it is absorbed, which makes iterations slow.
TEST(FlowBounds, HoldWhereHardlyAnythingIsAbsorbed) {
    std::mt19937_64 random(4);
    for (int i = 0; i < 50; ++i) {
        RandomCase made = random_case(random, 30, 0);
        for (Index j = 0; j < 30; ++j) made.factors(j, 30) = 0;
        for (Index j = 0; j < 30; ++j) made.factors.row(j) /= made.factors.row(j).sum();
        made.laws.reflected.setConstant(1);
        made.laws.reflected[0] = 1 - 1e-6;
        const auto bounds = bound_irradiation(sparse(made.factors, made.factors), made.laws);
        const Eigen::VectorXd h = irradiation(made.factors, made.laws);
        const double scale = h.cwiseAbs().maxCoeff();
        EXPECT_GE((bounds.high - h).minCoeff(), -1e-9 * scale) << "of the direct solution's own rounding";
        EXPECT_GE((h - bounds.low).minCoeff(), -1e-9 * scale);
        EXPECT_LT((bounds.high - bounds.low).maxCoeff(), 1e-4 * scale);
    }
}

}  // namespace
}  // namespace ff
