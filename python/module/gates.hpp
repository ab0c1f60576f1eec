#pragma once

#include <pybind11/pybind11.h>

namespace ff::python {

/// Adds `judge` and what it returns.
void bind_gates(pybind11::module_& module);

}  // namespace ff::python
