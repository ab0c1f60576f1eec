#pragma once

#include "studies/verdicts/gate_result.hpp"

#include <string>

namespace ff::reports {

/// summary.md: a comment for a pull request. One row per gate, those that did not pass first.
std::string gates_markdown(const studies::gates::CheckResults& check);

}  // namespace ff::reports
