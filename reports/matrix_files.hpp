#pragma once

#include "studies/store.hpp"

#include <Eigen/Core>

#include <map>
#include <string>

namespace ff::reports {

/// A dense matrix in the MatrixMarket exchange format ("array real general"), every digit kept.
/// @param comment  one line, may be empty
std::string matrix_market(const Eigen::MatrixXd& matrix, const std::string& comment);

/// The same as a NumPy .npy file, version 1.0; a single column is one-dimensional. @see docs/results.md
std::string npy(const Eigen::MatrixXd& matrix);

/// The first trial of every cell, as its method completes it, and the exact factors: form factors, areas, and for a
/// study with [radiosity] the matrices I - P F with their right-hand sides; of rays and kernels also the factors
/// between patches, where they are not too many. Contents by path.
std::map<std::string, std::string> matrix_files(const studies::Store& store);

}  // namespace ff::reports
