#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace ff::python {

/// Adds an estimator that is a Python function: estimate(scene, samples, seed, trial) gives an array (faces, faces) of
/// form factors. It is found as `name` until another function takes the name, and as `name`#`hash`.
/// @param has_sizes  false where it takes no samples  @param randomised  false where every seed gives the same
void add_estimator(const std::string& name, const std::string& hash, pybind11::function estimate, bool has_sizes,
                   bool randomised);

}  // namespace ff::python
