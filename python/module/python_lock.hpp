#pragma once

#include <pybind11/pybind11.h>

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

}  // namespace ff::python
