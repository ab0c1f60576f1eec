#include "reports/json/json_values.hpp"

namespace ff::reports {

Json optional_json(const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json interval_json(const std::optional<stats::Interval>& interval) {
    if (!interval) return nullptr;
    return {{"low", interval->low},
            {"high", interval->high},
            {"level", interval->level},
            {"method", interval->method},
            {"n", interval->n}};
}

}  // namespace ff::reports
