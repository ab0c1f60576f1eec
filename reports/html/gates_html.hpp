#pragma once

#include "studies/verdicts/gate_result.hpp"

#include <string>

namespace ff::reports {

/// summary.html: one row per gate with a picture of its interval in its band. A single page without scripts.
std::string gates_html(const studies::gates::CheckResults& check);

}  // namespace ff::reports
