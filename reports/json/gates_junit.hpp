#pragma once

#include "studies/verdicts/gate_result.hpp"

#include <string>
#include <vector>

namespace ff::reports {

/// The parts of a JUnit file besides the verdicts; callers read the clock.
struct JunitContext {
    std::string timestamp;  ///< when the check started, as 2026-11-20T16:30:00
    std::string hostname;
    std::vector<double> seconds;     ///< time of each finished gate
    std::vector<std::string> notes;  ///< a note on each finished gate, reported but not judged; may be an empty text
};

/// One test case per gate, in the common format of build servers. Unfinished gates are errors, so that the file of a
/// killed run is never green; so are inconclusive ones.
/// @pre as many seconds and notes as results
std::string junit_xml(const studies::gates::CheckResults& check, const JunitContext& context);

}  // namespace ff::reports
