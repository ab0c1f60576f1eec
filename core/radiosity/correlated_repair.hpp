#pragma once

#include "core/radiosity/repair.hpp"

#include <Eigen/Core>

#include <vector>

namespace ff {

/// Upper limit of patches for `balance_correlated`: its systems have about n^2 / 2 unknowns.
inline constexpr Eigen::Index most_correlated_patches = 24;

/// As `balance`, where the errors within a row are correlated in a known way: the factors with the least sum over rows
/// of (f - estimate)' C^+ (f - estimate), C^+ the generalised inverse of the row's covariance. Rows are independent of
/// each other. An active-set method; directions in which a row's covariance has no variance are not tied to the
/// estimate but left to the constraints (rows of rays sum to 1 in every trial).
/// @param covariances one n x n matrix for each row, positive semidefinite @param sight others stay 0
/// @pre at most `most_correlated_patches`; areas > 0
Balanced balance_correlated(const Eigen::MatrixXd& estimates, const std::vector<Eigen::MatrixXd>& covariances,
                            const Eigen::VectorXd& areas, const Sight& sight);

/// Mean and scatter of a row of factors over trials.
struct RowScatter {
    Eigen::Index trials = 0;
    Eigen::RowVectorXd mean;
    Eigen::MatrixXd scatter;  ///< sum of products of deviations from the mean
};

/// @param rows trials x targets
RowScatter scatter_of_row(const Eigen::MatrixXd& rows);

/// The same with one of the trials left out. @pre at least two
RowScatter without(const RowScatter& all, const Eigen::RowVectorXd& trial);

/// Covariance of a row of factors over trials, drawn towards that of counted hits (p on the diagonal, minus p p') of
/// the same total variance as if by `targets` further trials, so that a pair without a hit in any trial is not taken as
/// known exactly.
/// @param row of at least two trials @param floor added to the mean factor of pairs with sight: half a hit
Eigen::MatrixXd covariance_of_row(const RowScatter& row, const Eigen::Array<bool, Eigen::Dynamic, 1>& sight,
                                  double floor);

}  // namespace ff
