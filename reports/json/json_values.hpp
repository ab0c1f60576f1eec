#pragma once

#include "stats/interval.hpp"

#include <nlohmann/json.hpp>

#include <optional>

namespace ff::reports {

/// Objects keep the order in which keys are added.
using Json = nlohmann::ordered_json;

/// The value, or null.
Json optional_json(const std::optional<double>& value);

/// low, high, level, method and n; or null.
Json interval_json(const std::optional<stats::Interval>& interval);

}  // namespace ff::reports
