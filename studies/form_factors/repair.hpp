#pragma once

#include "studies/form_factors/form_factors.hpp"

namespace ff::studies {

/// The factors nearest to the estimates, by the widths of their intervals, that are reciprocal, sum to 1 in every row
/// and are nowhere negative (core/radiosity/repair.hpp).
RepairedFactors repair(const FormFactorMatrix& matrix);

/// What repaired factors are beside those of the matrix.
RepairedFactors compare_repaired(const FormFactorMatrix& matrix, Eigen::MatrixXd repaired, bool possible);

/// @throws UserError for a scene that is not closed: nothing says what its rows add up to
void expect_repairable(const Scene& scene);

}  // namespace ff::studies
