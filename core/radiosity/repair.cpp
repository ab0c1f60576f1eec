#include "core/radiosity/repair.hpp"

#include "core/support/contract.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ff {
namespace {

constexpr int most_newton_steps = 100;

/// The exchange area s = A_i F_ij of a pair minimises curvature s^2 - 2 slope s, with a multiplier of each patch.
struct PairTerms {
    SparseFactors curvature;
    SparseFactors slope;  ///< has a place for each of `curvature`, in the same order

    PairTerms(const SparseFactors& estimates, const SparseFactors& weights, const Eigen::VectorXd& areas) {
        const SparseFactors by_area = areas.cwiseInverse().asDiagonal() * weights;
        const SparseFactors one_way = areas.cwiseInverse().asDiagonal() * by_area;
        const SparseFactors pull = by_area.cwiseProduct(estimates);
        curvature = one_way + SparseFactors(one_way.transpose());
        slope = pull + SparseFactors(pull.transpose()) + 0 * curvature;
        FF_EXPECT(slope.nonZeros() == curvature.nonZeros());
        // A patch and itself are one estimate, not two.
        each_place([&](Eigen::Index i, Eigen::Index j, Eigen::Index place) {
            if (i != j) return;
            curvature.valuePtr()[place] /= 2;
            slope.valuePtr()[place] /= 2;
        });
    }

    /// @param use  takes row, column and place of each stored pair
    template <class Use>
    void each_place(const Use& use) const {
        for (Eigen::Index i = 0; i < curvature.rows(); ++i) {
            for (Eigen::Index place = curvature.outerIndexPtr()[i]; place < curvature.outerIndexPtr()[i + 1]; ++place)
                use(i, Eigen::Index{curvature.innerIndexPtr()[place]}, place);
        }
    }

    /// Exchange areas for given multipliers, none negative.
    void find_exchange(const Eigen::VectorXd& multipliers, SparseFactors& exchange) const {
        each_place([&](Eigen::Index i, Eigen::Index j, Eigen::Index place) {
            const double bend = curvature.valuePtr()[place];
            const double force = i == j ? multipliers[i] : multipliers[i] + multipliers[j];
            exchange.valuePtr()[place] = bend > 0 ? std::max(0.0, (slope.valuePtr()[place] + force) / bend) : 0;
        });
    }

    /// The derivative of the row sums of exchange areas by the multipliers, off the diagonal, and the diagonal.
    void find_derivative(const SparseFactors& exchange, SparseFactors& beside, Eigen::VectorXd& diagonal) const {
        diagonal.setZero();
        each_place([&](Eigen::Index i, Eigen::Index j, Eigen::Index place) {
            const double slack = exchange.valuePtr()[place] > 0 ? 1 / curvature.valuePtr()[place] : 0;
            beside.valuePtr()[place] = i == j ? 0 : slack;
            diagonal[i] += slack;
        });
    }
};

/// Solves (diagonal + beside) x = right by conjugate gradients. Scaled by its diagonal the matrix is 1 plus a small
/// part: a few steps do, where elimination takes n^3 / 3. Patches that see only each other leave a direction free,
/// which conjugate gradients never enter.
Eigen::VectorXd solve_scaled(const SparseFactors& beside, const Eigen::VectorXd& diagonal,
                             const Eigen::VectorXd& right) {
    const Eigen::VectorXd scale = (diagonal.array() > 0).select(diagonal.array().inverse(), 1.0);
    const double enough = std::pow(std::numeric_limits<double>::epsilon(), 2) * right.squaredNorm();
    Eigen::VectorXd result = Eigen::VectorXd::Zero(right.size());
    Eigen::VectorXd residual = right;
    Eigen::VectorXd direction = scale.cwiseProduct(residual);
    double steepness = residual.dot(direction);
    for (Eigen::Index step = 0; step < 2 * right.size() && residual.squaredNorm() > enough; ++step) {
        const Eigen::VectorXd image = diagonal.cwiseProduct(direction) + beside * direction;
        const double length = steepness / direction.dot(image);
        if (!std::isfinite(length)) break;
        result += length * direction;
        residual -= length * image;
        const double before = std::exchange(steepness, residual.dot(scale.cwiseProduct(residual)));
        direction = scale.cwiseProduct(residual) + steepness / before * direction;
    }
    return result;
}

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

Balanced balance(const SparseFactors& estimates, const SparseFactors& weights, const Eigen::VectorXd& areas) {
    FF_EXPECT(estimates.rows() == areas.size() && estimates.cols() == areas.size());
    FF_EXPECT(weights.rows() == estimates.rows() && weights.cols() == estimates.cols());
    const PairTerms terms(estimates, weights, areas);
    const Eigen::Index n = areas.size();
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(n);
    Eigen::VectorXd multipliers = Eigen::VectorXd::Zero(n);
    SparseFactors exchange = terms.curvature;
    terms.find_exchange(multipliers, exchange);
    SparseFactors beside = terms.curvature;
    Eigen::VectorXd diagonal(n);
    Balanced result;
    // Newton on the dual: the derivative of the row sums changes only where an exchange area reaches or leaves 0.
    for (int step = 0; step < most_newton_steps; ++step) {
        const Eigen::VectorXd missing = areas - exchange * ones;
        result.balanced = missing.cwiseAbs().maxCoeff() <= 1e-13 * areas.maxCoeff();
        if (result.balanced) break;
        terms.find_derivative(exchange, beside, diagonal);
        const Eigen::VectorXd change = solve_scaled(beside, diagonal, missing);
        if (!change.allFinite()) break;
        multipliers += change;
        terms.find_exchange(multipliers, exchange);
    }
    result.factors = areas.cwiseInverse().asDiagonal() * exchange.pruned();
    return result;
}

}  // namespace ff
