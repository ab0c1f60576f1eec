#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <string>

namespace ff::python {

/// Adds a sampler whose sets a Python function makes: fill(n, d, seed, trial) gives an array (n, d) of numbers in
/// [0, 1). It is found as `name` until another function takes the name, and as `name`#`hash`.
/// @param randomised  false where every seed gives the same points
/// @return the full name
std::string add_function(const std::string& name, const std::string& hash, pybind11::function fill,
                         std::size_t most_dimension, bool randomised);

}  // namespace ff::python
