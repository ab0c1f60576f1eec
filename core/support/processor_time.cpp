#include "core/support/processor_time.hpp"

#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>

#include <ctime>

namespace ff {
namespace {

double seconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Of programs, less what is not counted.
thread_local double beside_this_thread = 0;

}  // namespace

double processor_seconds() {
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec) + beside_this_thread;
}

pid_t wait_counting(pid_t child, int& status, int options) {
    rusage used{};
    const pid_t ended = ::wait4(child, &status, options, &used);
    if (ended > 0) beside_this_thread += seconds(used.ru_utime) + seconds(used.ru_stime);
    return ended;
}

UncountedTime::~UncountedTime() {
    beside_this_thread -= processor_seconds() - begin_;
}

}  // namespace ff
