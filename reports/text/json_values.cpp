#include "reports/text/json_values.hpp"

#include <cmath>

namespace ff::reports {

Json finite_json(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json interval_json(const std::optional<stats::Interval>& interval) {
    if (!interval) return nullptr;
    return {{"low", finite_json(interval->low)},
            {"high", finite_json(interval->high)},
            {"level", interval->level},
            {"method", interval->method},
            {"n", interval->n}};
}

}  // namespace ff::reports
