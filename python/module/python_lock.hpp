#pragma once

#include <pybind11/pybind11.h>

#include <optional>

namespace ff::python {

/// The interpreter's lock, held from any thread. What the interpreter keeps about one of our threads stays until that
/// thread ends: making it anew takes longer than calling a function.
class PythonLock {
    struct Known {
        pybind11::gil_scoped_acquire made;
        pybind11::gil_scoped_release released;
    };

    static bool make_known() {
        if (PyGILState_GetThisThreadState() != nullptr) return true;  // Python's own threads among them
        static const thread_local Known until_the_thread_ends;
        return true;
    }

    bool known_ = make_known();
    pybind11::gil_scoped_acquire held_;
};

/// The opposite: releases the lock, where this thread holds it. To be used while waiting for another thread, which may
/// need the lock.
class WithoutPythonLock {
  public:
    WithoutPythonLock() {
        if (PyGILState_Check() == 1) released_.emplace();
    }

  private:
    std::optional<pybind11::gil_scoped_release> released_;
};

}  // namespace ff::python
