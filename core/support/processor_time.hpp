#pragma once

#include <sys/types.h>

namespace ff {

/// Processor time in seconds, user and system, that this thread has used, with that of programs which it has started
/// and waited for, as the system accounts it. Only differences are meaningful, and no result may depend on them.
double processor_seconds();

/// Waits as `waitpid` does, and adds the program's processor time if it has ended.
pid_t wait_counting(pid_t child, int& status, int options);

/// Excludes what this thread and its programs use during its lifetime.
class UncountedTime {
  public:
    UncountedTime() : begin_(processor_seconds()) {}
    ~UncountedTime();
    UncountedTime(const UncountedTime&) = delete;
    UncountedTime& operator=(const UncountedTime&) = delete;

  private:
    double begin_;
};

}  // namespace ff
