#include "core/radiosity/linear_map.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <random>

namespace ff {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST(LinearMap, IsSolvedLikeItsMatrix) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform;
    for (const Index n : {1, 2, 30}) {
        const MatrixXd shares =
            MatrixXd::NullaryExpr(n, n, [&] { return 0.99 * uniform(random) / static_cast<double>(n); });
        const MatrixXd matrix = MatrixXd::Identity(n, n) - shares;
        const VectorXd right = VectorXd::NullaryExpr(n, [&] { return uniform(random); });
        const VectorXd exact = matrix.partialPivLu().solve(right);
        const LinearMap map = [&](const VectorXd& x) -> VectorXd { return matrix * x; };
        for (const VectorXd& guess : {VectorXd(VectorXd::Zero(n)), exact, VectorXd(1e3 * exact)})
            EXPECT_LT((solve(map, right, guess, 1e-14, 500) - exact).norm(), 1e-11 * exact.norm()) << n;
    }
}

TEST(LinearMap, StopsAsNearAsTheToleranceAsks) {
    constexpr Index n = 50;
    VectorXd diagonal = VectorXd::LinSpaced(n, 1, 100);
    int products = 0;
    const LinearMap map = [&](const VectorXd& x) -> VectorXd {
        ++products;
        return diagonal.cwiseProduct(x);
    };
    const VectorXd right = VectorXd::Ones(n);
    const VectorXd rough = solve(map, right, VectorXd::Zero(n), 1e-2, 500);
    const int for_rough = products;
    EXPECT_LE((diagonal.cwiseProduct(rough) - right).norm(), 1e-2 * right.norm());
    products = 0;
    const VectorXd fine = solve(map, right, VectorXd::Zero(n), 1e-12, 500);
    EXPECT_LE((diagonal.cwiseProduct(fine) - right).norm(), 1e-11 * right.norm());
    EXPECT_LT(for_rough, products);
}

}  // namespace
}  // namespace ff
