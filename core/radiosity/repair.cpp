#include "core/radiosity/repair.hpp"

#include "core/contract.hpp"

#include <Eigen/Cholesky>

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

Eigen::MatrixXd weights_of_hits(const Eigen::MatrixXd& factors, const Eigen::VectorXd& rays) {
    FF_EXPECT(factors.rows() == rays.size() && rays.minCoeff() > 0);
    const auto targets = static_cast<double>(factors.cols() - 1);
    Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(factors.rows(), factors.cols());
    for (Eigen::Index i = 0; i < factors.rows(); ++i) {
        for (Eigen::Index j = 0; j < factors.cols(); ++j) {
            const double share = (factors(i, j) * rays[i] + 0.5) / (rays[i] + targets / 2);
            if (i != j) weights(i, j) = rays[i] / share;
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
        // Two patches that see only each other leave the difference of their multipliers free.
        derivative.diagonal().array() += 1e-14 * derivative.diagonal().maxCoeff();
        multipliers += derivative.ldlt().solve(missing);
        exchange = terms.exchange(multipliers);
    }
    result.factors = areas.cwiseInverse().asDiagonal() * exchange;
    result.chi_squared = weights.cwiseProduct((result.factors - estimates).cwiseAbs2()).sum();
    return result;
}

}  // namespace ff
