#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <future>

namespace ff::python {

/// Carries out `work(stop)` without the interpreter's lock, and looks for Ctrl-C meanwhile: it sets the flag, waits
/// until the work has wound up, and raises KeyboardInterrupt. @throws what the work throws
template <class Work>
void run_interruptibly(Work work) {
    constexpr std::chrono::milliseconds between_looks{50};
    std::atomic<bool> stop{false};
    bool interrupted = false;
    {
        const pybind11::gil_scoped_release released;
        auto done = std::async(std::launch::async, [&] { work(stop); });
        while (done.wait_for(between_looks) != std::future_status::ready) {
            if (interrupted) continue;
            const pybind11::gil_scoped_acquire held;
            interrupted = PyErr_CheckSignals() != 0;
            stop = interrupted;
        }
        // Its thread may want the lock until it has ended: it is waited for here.
        if (!interrupted) done.get();
    }
    if (interrupted) throw pybind11::error_already_set();
}

}  // namespace ff::python
