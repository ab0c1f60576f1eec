#pragma once

#include "studies/verdicts/check_results.hpp"

#include <string>
#include <vector>

namespace ff::reports {

/// What a JUnit file has beside the verdicts; the caller looks at clocks.
struct JunitContext {
    std::string timestamp;  ///< of the start, as 2026-11-20T16:30:00
    std::string hostname;
    std::vector<double> seconds;     ///< that each finished gate took
    std::vector<std::string> notes;  ///< of each finished gate, told but not judged; may be empty texts
};

/// One test case a gate, in the common format of build servers. Gates that are not done yet are errors, so that the
/// file of a run that was killed is never green; so are inconclusive ones.
/// @pre as many seconds and notes as results
std::string junit_xml(const studies::CheckResults& check, const JunitContext& context);

}  // namespace ff::reports
