#pragma once

#include <sys/types.h>

namespace ff {

/// Processor time, user and system, that this thread has used, in seconds, with that of the programs it has started and
/// seen end, by the accounts of the system. Only differences mean anything, and no result may depend on them.
double processor_seconds();

/// As `waitpid`, and counts what the program has used where it has ended.
pid_t wait_counting(pid_t child, int& status, int options);

/// What this thread and its programs use while it lives is left out.
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
