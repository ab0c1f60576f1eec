#pragma once

#include "studies/store/store.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <functional>
#include <map>
#include <ostream>
#include <string>
#include <string_view>

namespace ff::reports {

/// A dense matrix in the MatrixMarket exchange format ("array real general"), every digit kept.
/// @param comment  one line, may be empty
void write_matrix_market(std::ostream& out, const Eigen::MatrixXd& matrix, const std::string& comment);
std::string matrix_market(const Eigen::MatrixXd& matrix, const std::string& comment);

/// The same, but "coordinate real general" where at most a quarter of the entries are nonzero.
void write_sparse_matrix_market(std::ostream& out, const Eigen::SparseMatrix<double>& matrix,
                                const std::string& comment);

/// What stands before the numbers of an array in NumPy's format, version 1.0. @param fortran_order, shape  as Python
/// writes them
std::string npy_header(std::string_view type, std::string_view fortran_order, std::string_view shape);

/// A matrix as a NumPy .npy file, version 1.0; a single column is one-dimensional. @see docs/results.md
void write_npy(std::ostream& out, const Eigen::MatrixXd& matrix);
std::string npy(const Eigen::MatrixXd& matrix);

/// The first trial of every cell, as completed by its method, and the exact factors: form factors, areas, and for a
/// study with [radiosity] the matrices I - P F with their right-hand sides; for rays and kernels also the factors
/// between patches, unless there are too many. Contents by path.
std::map<std::string, std::string> matrix_files(const studies::Store& store);

/// Takes a matrix to be written to `path`, which has no extension; the matrix is not kept.
using TakeMatrix =
    std::function<void(const std::string& path, const Eigen::MatrixXd& matrix, const std::string& comment)>;

/// The factors of the first trial between patches and the matrices I - P F made of them, of every cell with factors
/// between patches, one after the other: each may take 800 MB. @throws UserError where the study has no such cell, or
/// no [radiosity]
void patch_systems(const studies::Store& store, const TakeMatrix& take);

}  // namespace ff::reports
