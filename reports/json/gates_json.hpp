#pragma once

#include "studies/verdicts/gate_result.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace ff::reports {

/// verdicts.json, schema "ffstudy.verdicts/1" (docs/gates.md).
std::string verdicts_json(const studies::gates::CheckResults& check);

/// A record of verdicts.json and of verdicts.csv (docs/gates.md).
nlohmann::ordered_json comparison_json(const studies::gates::Comparison& c);

}  // namespace ff::reports
