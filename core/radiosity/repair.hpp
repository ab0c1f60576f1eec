#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace ff {

/// Which patches see which. Symmetric; true on the diagonal where a patch sees itself.
using Sight = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>;

/// All pairs except that of a patch with itself, as the faces of a convex room see each other.
Sight all_but_itself(Eigen::Index patches);

/// Every row divided by its sum: closure, at the cost of reciprocity. Rows of zeros are left alone.
Eigen::MatrixXd normalise_rows(const Eigen::MatrixXd& factors);

/// Weights (1 / variance, for differences that sum to 0 in each row) of factors that are shares of counted hits. The
/// covariance of such shares is multinomial, and its generalised inverse is diagonal: N / p. The unknown p is estimated
/// from the hits of both directions, which estimate the same exchange area, half a hit added to each, so that a pair
/// without hits is not taken to have no variance. (With each direction's own hits alone, the one with fewer would weigh
/// more, and the mean of the two would be too small.)
/// @param factors hits / N @param rays N of each row, > 0 @param areas > 0
/// @param sight pairs that can see each other; the others get weight 0
Eigen::MatrixXd weights_of_hits(const Eigen::MatrixXd& factors, const Eigen::VectorXd& rays,
                                const Eigen::VectorXd& areas, const Sight& sight);

/// Weights of factors whose errors are unknown: the variance is taken as proportional to the factor, like that of hits.
/// Factors of exactly 0 have none and stay 0.
Eigen::MatrixXd weights_of_values(const Eigen::MatrixXd& factors);

/// Factors of which most are 0, by rows.
using SparseFactors = Eigen::SparseMatrix<double, Eigen::RowMajor>;

struct Balanced {
    SparseFactors factors;
    bool balanced = false;  ///< false where no such factors exist, e.g. where one patch exceeds all others together
};

/// The factors nearest to estimates (weighted least squares) that are reciprocal, sum to 1 in every row and are nowhere
/// negative. With weights of hits this is the maximum-likelihood smoothing of [daun2005] to first order. Memory and the
/// time of a step are proportional to the number of weights that are not 0.
/// @param weights 1 / variance of each estimate; pairs whose two weights are 0 stay 0 @pre areas > 0, equal sizes
Balanced balance(const SparseFactors& estimates, const SparseFactors& weights, const Eigen::VectorXd& areas);

}  // namespace ff
