#pragma once

#include "stats/basics/interval.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <optional>

namespace ff::reports {

/// Objects keep the order in which keys are added.
using Json = nlohmann::ordered_json;

/// The value, or null.
template <class Value>
Json optional_json(const std::optional<Value>& value) {
    return value ? Json(*value) : Json(nullptr);
}

/// The number; null where it is infinite or not a number, which JSON cannot say.
inline Json finite_json(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

/// low, high (null where infinite), level, method and n; or null.
inline Json interval_json(const std::optional<stats::Interval>& interval) {
    if (!interval) return nullptr;
    return {{"low", finite_json(interval->low)},
            {"high", finite_json(interval->high)},
            {"level", interval->level},
            {"method", interval->method},
            {"n", interval->n}};
}

}  // namespace ff::reports
