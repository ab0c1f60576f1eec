#pragma once

#include <pybind11/pybind11.h>

namespace ff::python {

/// Adds `admit`, `run_study` and what they return.
void bind_study(pybind11::module_& module);

}  // namespace ff::python
