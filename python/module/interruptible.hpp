#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace ff::python {

/// Carries out `work(stop)` without the interpreter's lock, and looks for Ctrl-C meanwhile: it sets the flag, waits
/// until the work has wound up, and raises KeyboardInterrupt. @throws what the work throws
template <class Work>
void run_interruptibly(Work work) {
    constexpr std::chrono::milliseconds between_looks{50};
    std::atomic<bool> stop{false};
    std::mutex mutex;
    std::condition_variable change;
    bool done = false;
    bool interrupted = false;
    std::exception_ptr failure;
    {
        const pybind11::gil_scoped_release released;
        std::thread worker([&] {
            try {
                work(stop);
            } catch (...) {
                failure = std::current_exception();
            }
            const std::lock_guard lock(mutex);
            done = true;
            change.notify_all();
        });
        std::unique_lock lock(mutex);
        while (!change.wait_for(lock, between_looks, [&] { return done; })) {
            if (interrupted) continue;
            lock.unlock();
            {
                const pybind11::gil_scoped_acquire held;
                interrupted = PyErr_CheckSignals() != 0;
            }
            if (interrupted) stop = true;
            lock.lock();
        }
        lock.unlock();
        worker.join();
    }
    if (interrupted) throw pybind11::error_already_set();
    if (failure) std::rethrow_exception(failure);
}

}  // namespace ff::python
