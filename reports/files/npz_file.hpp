#pragma once

#include "studies/form_factors/form_factors.hpp"

#include <Eigen/SparseCore>

#include <ostream>

namespace ff::reports {

/// A sparse matrix by rows as a .npz file, as scipy.sparse.load_npz reads it: indices, indptr, format ("csr"), shape
/// and data. @pre it is compressed, as after setFromTriplets
/// @throws UserError for more than 4 GiB
void write_sparse_npz(std::ostream& out, const Eigen::SparseMatrix<double, Eigen::RowMajor>& matrix);

/// The values of randomisations as a .npz file. docs/form-factors.md has its arrays. @throws UserError for more than
/// 4 GiB
void write_randomisations(std::ostream& out, const studies::form_factors::Matrix& matrix);

}  // namespace ff::reports
