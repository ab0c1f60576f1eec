#pragma once

#include "studies/store/store.hpp"

#include <Eigen/Core>

#include <functional>
#include <map>
#include <string>

namespace ff::reports {

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
