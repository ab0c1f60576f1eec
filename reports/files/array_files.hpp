#pragma once

#include "samplers/point_sets/point_set.hpp"
#include "studies/form_factors/form_factors.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>

namespace ff::reports {

/// A dense matrix in the MatrixMarket exchange format ("array real general"), every digit kept.
/// @param comment  one line, may be empty
void write_matrix_market(std::ostream& out, const Eigen::MatrixXd& matrix, const std::string& comment);
std::string matrix_market(const Eigen::MatrixXd& matrix, const std::string& comment);

/// The same, but "coordinate real general" where at most a quarter of the entries are nonzero.
void write_sparse_matrix_market(std::ostream& out, const Eigen::SparseMatrix<double>& matrix,
                                const std::string& comment);

/// A matrix as a NumPy .npy file, version 1.0; a single column is one-dimensional. @see docs/results.md
void write_npy(std::ostream& out, const Eigen::MatrixXd& matrix);
/// The same with 1 dimension or 2, where a matrix may have a single column too.
void write_npy(std::ostream& out, const Eigen::MatrixXd& matrix, int dimensions);
std::string npy(const Eigen::MatrixXd& matrix);

/// A sparse matrix by rows as a .npz file, as scipy.sparse.load_npz reads it: indices, indptr, format ("csr"), shape
/// and data. @pre it is compressed, as after setFromTriplets
/// @throws UserError for more than 4 GiB
void write_sparse_npz(std::ostream& out, const Eigen::SparseMatrix<double, Eigen::RowMajor>& matrix);

/// The values of randomisations as a .npz file. docs/form-factors.md has its arrays. @throws UserError for more than
/// 4 GiB
void write_randomisations(std::ostream& out, const studies::form_factors::Matrix& matrix);

using WritePointSet = std::function<void(std::ostream&, const samplers::PointSet&)>;

/// How the first set is written, by the extension: .npy (n, d) of float64; .csv and .dat, one point per line with all
/// digits; .svg, a square for each pair of coordinates. The first three read back as the same points.
/// @throws UserError for another extension
WritePointSet point_set_format(const std::filesystem::path& file);

}  // namespace ff::reports
