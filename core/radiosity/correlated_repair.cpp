#include "core/radiosity/correlated_repair.hpp"

#include "core/support/contract.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <cstddef>

namespace ff {
namespace {

constexpr int most_changes_of_the_active_set = 500;
constexpr double rank_tolerance = 1e-9;  // of a covariance, relative to its largest eigenvalue

Eigen::MatrixXd generalised_inverse(const Eigen::MatrixXd& covariance) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(covariance);
    const double least = rank_tolerance * eigen.eigenvalues().cwiseAbs().maxCoeff();
    const Eigen::VectorXd inverse =
        eigen.eigenvalues().unaryExpr([&](double value) { return value > least ? 1 / value : 0.0; });
    return eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
}

/// minimise x' H x / 2 - g' x with C x = c and x >= 0; x are the exchange areas of pairs with sight.
struct Problem {
    std::vector<std::pair<Eigen::Index, Eigen::Index>> pairs;
    Eigen::MatrixXd hessian, constraints;
    Eigen::VectorXd gradient, sums;

    Problem(const Eigen::MatrixXd& estimates, const std::vector<Eigen::MatrixXd>& covariances,
            const Eigen::VectorXd& areas, const Sight& sight) {
        const Eigen::Index n = areas.size();
        Eigen::MatrixXi unknown = Eigen::MatrixXi::Constant(n, n, -1);
        for (Eigen::Index i = 0; i < n; ++i) {
            for (Eigen::Index j = i; j < n; ++j) {
                if (!sight(i, j)) continue;
                unknown(i, j) = unknown(j, i) = static_cast<int>(pairs.size());
                pairs.emplace_back(i, j);
            }
        }
        const auto size = static_cast<Eigen::Index>(pairs.size());
        hessian = Eigen::MatrixXd::Zero(size, size);
        gradient = Eigen::VectorXd::Zero(size);
        constraints = Eigen::MatrixXd::Zero(n, size);
        sums = areas;
        for (Eigen::Index i = 0; i < n; ++i) {
            const Eigen::MatrixXd weights = generalised_inverse(covariances[static_cast<std::size_t>(i)]);
            const Eigen::VectorXd pull = weights * estimates.row(i).transpose() / areas[i];
            for (Eigen::Index j = 0; j < n; ++j) {
                if (unknown(i, j) < 0) continue;
                constraints(i, unknown(i, j)) = 1;
                gradient[unknown(i, j)] += pull[j];
                for (Eigen::Index k = 0; k < n; ++k) {
                    if (unknown(i, k) >= 0)
                        hessian(unknown(i, j), unknown(i, k)) += weights(j, k) / (areas[i] * areas[i]);
                }
            }
        }
        // Of the size of the constraints, so that both keep their digits.
        const double scale = hessian.cwiseAbs().maxCoeff();
        if (scale > 0) {
            hessian /= scale;
            gradient /= scale;
        }
    }

    /// The optimum where some unknowns are held at 0, with the force that holds them.
    struct Point {
        Eigen::VectorXd x, force;
    };
    [[nodiscard]] Point solve(const std::vector<bool>& held) const {
        const Eigen::Index size = hessian.rows();
        const Eigen::Index conditions = constraints.rows();
        Eigen::MatrixXd system = Eigen::MatrixXd::Zero(size + conditions, size + conditions);
        Eigen::VectorXd right(size + conditions);
        system.topLeftCorner(size, size) = hessian;
        system.topRightCorner(size, conditions) = constraints.transpose();
        system.bottomLeftCorner(conditions, size) = constraints;
        right << gradient, sums;
        for (Eigen::Index k = 0; k < size; ++k) {
            if (!held[static_cast<std::size_t>(k)]) continue;
            system.row(k).setZero();
            system.col(k).setZero();
            system(k, k) = 1;
            right[k] = 0;
        }
        const Eigen::VectorXd solution = system.completeOrthogonalDecomposition().solve(right);
        Point point{solution.head(size), {}};
        point.force = hessian * point.x - gradient + constraints.transpose() * solution.tail(conditions);
        return point;
    }
};

/// Holds what would be negative, lets go what pulls away from 0. @return empty where that does not end
Eigen::VectorXd least_squares(const Problem& problem, double rounding) {
    std::vector<bool> held(problem.pairs.size(), false);
    for (int change = 0; change < most_changes_of_the_active_set; ++change) {
        const auto [x, force] = problem.solve(held);
        Eigen::Index least = 0;
        if (x.minCoeff(&least) < -rounding) {
            held[static_cast<std::size_t>(least)] = true;
            continue;
        }
        Eigen::Index freed = -1;
        double strongest = -1e-9;
        for (Eigen::Index k = 0; k < x.size(); ++k) {
            if (!held[static_cast<std::size_t>(k)] || force[k] >= strongest) continue;
            strongest = force[k];
            freed = k;
        }
        if (freed < 0) return x.cwiseMax(0.0);
        held[static_cast<std::size_t>(freed)] = false;
    }
    return {};
}

}  // namespace

Balanced balance_correlated(const Eigen::MatrixXd& estimates, const std::vector<Eigen::MatrixXd>& covariances,
                            const Eigen::VectorXd& areas, const Sight& sight) {
    const Eigen::Index n = areas.size();
    FF_EXPECT(n <= most_correlated_patches && estimates.rows() == n && estimates.cols() == n);
    FF_EXPECT(covariances.size() == static_cast<std::size_t>(n) && sight.rows() == n);
    const Problem problem(estimates, covariances, areas, sight);
    const Eigen::VectorXd exchange = least_squares(problem, 1e-12 * areas.maxCoeff());
    Balanced result;
    if (exchange.size() == 0) return result;
    result.factors = Eigen::MatrixXd::Zero(n, n);
    for (std::size_t k = 0; k < problem.pairs.size(); ++k) {
        const auto [i, j] = problem.pairs[k];
        result.factors(i, j) = exchange[static_cast<Eigen::Index>(k)] / areas[i];
        result.factors(j, i) = exchange[static_cast<Eigen::Index>(k)] / areas[j];
    }
    result.balanced = (result.factors.rowwise().sum().array() - 1).abs().maxCoeff() <= 1e-10;
    for (Eigen::Index i = 0; i < n; ++i) {
        const Eigen::VectorXd correction = (result.factors - estimates).row(i);
        result.chi_squared +=
            correction.dot(generalised_inverse(covariances[static_cast<std::size_t>(i)]) * correction);
    }
    return result;
}

RowScatter scatter_of_row(const Eigen::MatrixXd& rows) {
    RowScatter row;
    row.trials = rows.rows();
    row.mean = rows.colwise().mean();
    const Eigen::MatrixXd off = rows.rowwise() - row.mean;
    row.scatter = off.transpose() * off;
    return row;
}

RowScatter without(const RowScatter& all, const Eigen::RowVectorXd& trial) {
    FF_EXPECT(all.trials >= 2);
    const auto left = static_cast<double>(all.trials - 1);
    const Eigen::RowVectorXd off = trial - all.mean;
    return {.trials = all.trials - 1,
            .mean = all.mean - off / left,
            .scatter = all.scatter - (left + 1) / left * off.transpose() * off};
}

Eigen::MatrixXd covariance_of_row(const RowScatter& row, const Eigen::Array<bool, Eigen::Dynamic, 1>& sight,
                                  double floor) {
    FF_EXPECT(row.trials >= 2 && row.mean.size() == sight.size() && floor >= 0);
    const auto freedom = static_cast<double>(row.trials - 1);
    Eigen::VectorXd p = row.mean.transpose();
    for (Eigen::Index j = 0; j < p.size(); ++j) p[j] = sight[j] ? p[j] + floor : 0;
    if (p.sum() > 0) p /= p.sum();
    Eigen::MatrixXd counted = -p * p.transpose();
    counted.diagonal() += p;
    const double trace = counted.trace();
    if (trace > 0) counted *= row.scatter.trace() / freedom / trace;
    const auto further = static_cast<double>(sight.count());
    return (row.scatter + further * counted) / (freedom + further);
}

}  // namespace ff
