#include "core/support/processor_time.hpp"

#include <pthread.h>
#include <sys/resource.h>
#include <sys/wait.h>

namespace ff {
namespace {

double seconds(const rusage& used) {
    return static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
}

/// Processor time in seconds of the programs that this thread has waited for, less all time that is excluded by
/// UncountedTime.
thread_local double beside_this_thread = 0;

}  // namespace

double processor_seconds() {
    // The accounts of getrusage() may be kept in ticks of milliseconds, longer than many a trial takes.
    timespec used{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
    return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec) + beside_this_thread;
}

pid_t wait_counting(pid_t child, int& status, int options) {
    rusage used{};
    const pid_t ended = ::wait4(child, &status, options, &used);
    if (ended > 0) beside_this_thread += seconds(used);
    return ended;
}

UncountedTime::~UncountedTime() {
    beside_this_thread -= processor_seconds() - begin_;
}

}  // namespace ff
