#pragma once

#include <Eigen/SparseCore>

#include <ostream>

namespace ff::reports {

/// A sparse matrix by rows as a .npz file, as scipy.sparse.load_npz reads it: a zip archive, not compressed, of
/// indices, indptr, format ("csr"), shape and data in NumPy's format. @pre it is compressed, as after setFromTriplets
/// @throws UserError for more than a zip archive holds, 4 GiB
void write_sparse_npz(std::ostream& out, const Eigen::SparseMatrix<double, Eigen::RowMajor>& matrix);

}  // namespace ff::reports
