#pragma once

#include <pybind11/pybind11.h>

#include <optional>

namespace ff::python {

/// The interpreter's lock, held from any thread. What the interpreter keeps of a thread of ours stays until the thread
/// ends: to make it anew takes longer than to call a function.
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

/// The contrary: the lock given back, where this thread holds it. What waits for another thread waits so, since that
/// one may want the lock.
class WithoutPythonLock {
  public:
    WithoutPythonLock() {
        if (PyGILState_Check() == 1) released_.emplace();
    }

  private:
    std::optional<pybind11::gil_scoped_release> released_;
};

}  // namespace ff::python
