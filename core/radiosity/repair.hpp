#pragma once

#include <Eigen/Core>

namespace ff {

/// Every row divided by its sum: closure, at the cost of reciprocity. Rows without a factor stay.
Eigen::MatrixXd normalise_rows(const Eigen::MatrixXd& factors);

/// Weights (1 / variance, for differences that sum to 0 in each row) of factors that are shares of counted hits. The
/// covariance of such shares is multinomial, and its generalised inverse is diagonal: N / p. The unknown p is estimated
/// as (hits + 1/2) / (N + targets/2), so that no hit does not pass for no variance. @param factors hits / N
/// @param rays N of each row, > 0 @return 0 on the diagonal: no patch that is counted sees itself
Eigen::MatrixXd weights_of_hits(const Eigen::MatrixXd& factors, const Eigen::VectorXd& rays);

/// Weights of factors whose errors are not known: a variance that grows as the factor, as that of hits does. Factors of
/// exactly 0 have none and stay 0.
Eigen::MatrixXd weights_of_values(const Eigen::MatrixXd& factors);

struct Balanced {
    Eigen::MatrixXd factors;
    bool balanced = false;   ///< false where no such factors exist, e.g. one patch larger than all others together
    double chi_squared = 0;  ///< weighted sum of squared corrections
};

/// The factors nearest to estimates (weighted least squares) that are reciprocal, sum to 1 in every row and are nowhere
/// negative. With weights of hits this is the maximum-likelihood smoothing of [daun2005] to first order.
/// @param weights 1 / variance of each estimate; pairs whose two weights are 0 stay 0 @pre areas > 0, equal sizes
Balanced balance(const Eigen::MatrixXd& estimates, const Eigen::MatrixXd& weights, const Eigen::VectorXd& areas);

}  // namespace ff
