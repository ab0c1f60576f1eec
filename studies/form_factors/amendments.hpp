#pragma once

#include "core/radiosity/repair.hpp"
#include "studies/form_factors/form_factors.hpp"

#include <string>

namespace ff::studies::form_factors {

/// @throws UserError where a scene is closed, so that nothing leaves it, or has a face of that name
void expect_surroundings(const Scene& scene, const std::string& name);

/// The scene with the additional faces of its matrix that have no shape: its masks and, if they have a name, the
/// surroundings, which close it.
Scene with_added_faces(Scene scene, const std::string& surroundings);

/// Adds the masks of a scene to a matrix of its faces.
void add_masks(Matrix& matrix, const Scene& scene);

/// Adds a face that receives what leaves an open scene: what is missing of each row's sum, with an interval of that
/// width, to which the tolerance of entries does not apply. The face does not see itself, and has the area with which
/// its row adds up to 1.
void add_surroundings(Matrix& matrix);

/// The factors nearest to the estimates, by the widths of their intervals, that are reciprocal, sum to 1 in every row
/// and are nowhere negative (core/radiosity/repair.hpp).
RepairedFactors repair(const Matrix& matrix);

/// The same for other factors with the widths of these intervals.
Balanced balance_within(const Matrix& intervals, const Matrix::Sparse& factors);

/// How repaired factors compare with those of the matrix.
RepairedFactors compare_repaired(const Matrix& matrix, const Matrix::Sparse& repaired, bool possible);

/// @throws UserError for a scene that is not closed, whose row sums are unknown
void expect_repairable(const Scene& scene);

}  // namespace ff::studies::form_factors
