#pragma once

#include "studies/verdicts/gate_result.hpp"

#include <string>

namespace ff::reports {

/// verdicts.json, schema "ffstudy.verdicts/1" (docs/gates.md).
std::string verdicts_json(const studies::gates::CheckResults& check);

}  // namespace ff::reports
