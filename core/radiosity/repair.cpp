#include "core/radiosity/repair.hpp"

#include "core/support/contract.hpp"

#include <Eigen/IterativeLinearSolvers>

#include <algorithm>

namespace ff {
namespace {

constexpr int most_newton_steps = 100;

/// The exchange area s = A_i F_ij of a pair minimises curvature s^2 - 2 slope s, with a multiplier of each patch.
struct PairTerms {
    Eigen::MatrixXd curvature, slope;

    PairTerms(const Eigen::MatrixXd& estimates, const Eigen::MatrixXd& weights, const Eigen::VectorXd& areas) {
        const Eigen::MatrixXd by_area = areas.cwiseInverse().asDiagonal() * weights;
        const Eigen::MatrixXd one_way = areas.cwiseInverse().asDiagonal() * by_area;
        const Eigen::MatrixXd pull = by_area.cwiseProduct(estimates);
        curvature = one_way + one_way.transpose();
        slope = pull + pull.transpose();
        curvature.diagonal() /= 2;  // a patch and itself are one estimate, not two
        slope.diagonal() /= 2;
    }

    /// Exchange areas for given multipliers, none negative.
    [[nodiscard]] Eigen::MatrixXd exchange(const Eigen::VectorXd& multipliers) const {
        const Eigen::Index n = multipliers.size();
        Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, n);
        for (Eigen::Index j = 0; j < n; ++j) {
            for (Eigen::Index i = 0; i < n; ++i) {
                if (curvature(i, j) <= 0) continue;
                const double force = i == j ? multipliers[i] : multipliers[i] + multipliers[j];
                result(i, j) = std::max(0.0, (slope(i, j) + force) / curvature(i, j));
            }
        }
        return result;
    }
};

}  // namespace

Eigen::MatrixXd normalise_rows(const Eigen::MatrixXd& factors) {
    Eigen::VectorXd sums = factors.rowwise().sum();
    for (double& sum : sums) sum = sum > 0 ? sum : 1;
    return sums.cwiseInverse().asDiagonal() * factors;
}

Sight all_but_itself(Eigen::Index patches) {
    Sight sight = Sight::Constant(patches, patches, true);
    sight.matrix().diagonal().setConstant(false);
    return sight;
}

Eigen::MatrixXd weights_of_hits(const Eigen::MatrixXd& factors, const Eigen::VectorXd& rays,
                                const Eigen::VectorXd& areas, const Sight& sight) {
    FF_EXPECT(factors.rows() == rays.size() && rays.minCoeff() > 0 && areas.size() == rays.size());
    const Eigen::VectorXd density = rays.cwiseQuotient(areas);  // expected hits of a unit of exchange area
    Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(factors.rows(), factors.cols());
    for (Eigen::Index i = 0; i < factors.rows(); ++i) {
        for (Eigen::Index j = 0; j < factors.cols(); ++j) {
            if (!sight(i, j)) continue;
            const double hits = factors(i, j) * rays[i] + factors(j, i) * rays[j] + 1;
            const double exchange = hits / (density[i] + density[j]);
            weights(i, j) = rays[i] * areas[i] / exchange;
        }
    }
    return weights;
}

Eigen::MatrixXd weights_of_values(const Eigen::MatrixXd& factors) {
    return factors.unaryExpr([](double factor) { return factor > 0 ? 1 / factor : 0.0; });
}

Balanced balance(const Eigen::MatrixXd& estimates, const Eigen::MatrixXd& weights, const Eigen::VectorXd& areas) {
    FF_EXPECT(estimates.rows() == areas.size() && estimates.cols() == areas.size());
    FF_EXPECT(weights.rows() == estimates.rows() && weights.cols() == estimates.cols() && weights.minCoeff() >= 0);
    const PairTerms terms(estimates, weights, areas);
    const Eigen::Index n = areas.size();
    Eigen::VectorXd multipliers = Eigen::VectorXd::Zero(n);
    Eigen::MatrixXd exchange = terms.exchange(multipliers);
    Balanced result;
    // Newton on the dual: the derivative of the row sums changes only where an exchange area reaches or leaves 0.
    for (int step = 0; step < most_newton_steps; ++step) {
        const Eigen::VectorXd missing = areas - exchange.rowwise().sum();
        result.balanced = missing.cwiseAbs().maxCoeff() <= 1e-13 * areas.maxCoeff();
        if (result.balanced) break;
        Eigen::MatrixXd derivative = Eigen::MatrixXd::Zero(n, n);
        for (Eigen::Index i = 0; i < n; ++i) {
            for (Eigen::Index j = 0; j < n; ++j) {
                if (exchange(i, j) <= 0) continue;
                derivative(i, j) += 1 / terms.curvature(i, j);
                if (i != j) derivative(i, i) += 1 / terms.curvature(i, j);
            }
        }
        // Scaled by its diagonal it is 1 plus a small part: a few steps do, where elimination takes n^3 / 3. Patches
        // that see only each other leave a direction free, which conjugate gradients never enter.
        const Eigen::ConjugateGradient<Eigen::MatrixXd, Eigen::Lower | Eigen::Upper> solver(derivative);
        const Eigen::VectorXd change = solver.solve(missing);
        if (!change.allFinite()) break;
        multipliers += change;
        exchange = terms.exchange(multipliers);
    }
    result.factors = areas.cwiseInverse().asDiagonal() * exchange;
    return result;
}

}  // namespace ff
