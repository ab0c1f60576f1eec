#pragma once

#include "studies/form_factors/form_factors.hpp"

namespace ff::studies::form_factors {

/// The factors nearest to the estimates, by the widths of their intervals, that are reciprocal, sum to 1 in every row
/// and are nowhere negative (core/radiosity/repair.hpp).
RepairedFactors repair(const Matrix& matrix);

/// How repaired factors compare with those of the matrix.
RepairedFactors compare_repaired(const Matrix& matrix, Matrix::Sparse repaired, bool possible);

/// @throws UserError for a scene that is not closed, whose row sums are unknown
void expect_repairable(const Scene& scene);

}  // namespace ff::studies::form_factors
