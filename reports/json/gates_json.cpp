#include "reports/json/gates_json.hpp"

#include "reports/text/json_values.hpp"

namespace ff::reports {

Json comparison_json(const studies::gates::Comparison& c) {
    const auto& measurement = c.measurement;
    return {{"scene", c.scene},
            {"method", c.method},
            {"patches_per_face", optional_json(c.patches_per_face)},
            {"samples_per_patch", optional_json(c.samples_per_patch)},
            {"from_face", c.from_face},
            {"to_face", c.to_face},
            {"quantity", c.quantity},
            {"value", measurement ? Json(measurement->value) : Json(nullptr)},
            {"passing_interval", measurement ? interval_json(measurement->passing) : Json(nullptr)},
            {"failing_interval", measurement ? interval_json(measurement->failing) : Json(nullptr)},
            {"band", {{"low", finite_json(c.band.low)}, {"high", finite_json(c.band.high)}}},
            {"verdict", name(c.verdict)},
            {"minimum_detectable", measurement ? Json(measurement->minimum_detectable) : Json(nullptr)},
            {"alpha", c.levels.fail_alpha},
            {"pass_alpha", c.levels.pass_alpha},
            {"power", c.levels.power},
            {"trials", c.trials},
            {"note", c.note}};
}

std::string verdicts_json(const studies::gates::CheckResults& check) {
    Json gates = Json::array();
    for (const studies::gates::GateResult& result : check.results) {
        Json comparisons = Json::array();
        for (const studies::gates::Comparison& comparison : result.comparisons)
            comparisons.push_back(comparison_json(comparison));
        gates.push_back({{"gate", result.gate},
                         {"kind", name(result.kind)},
                         {"verdict", name(result.verdict)},
                         {"looks", result.looks},
                         {"evaluations", result.evaluations},
                         {"note", result.note},
                         {"comparisons", std::move(comparisons)}});
    }
    const Json root = {
        {"schema", "ffstudy.verdicts/1"}, {"bands", check.spec.name},         {"seed", check.spec.seed.value},
        {"alpha", check.spec.alpha},      {"power", check.spec.power},        {"looks", check.spec.looks},
        {"complete", check.complete()},   {"verdict", name(check.verdict())}, {"gates", std::move(gates)}};
    return root.dump(1) + "\n";
}

}  // namespace ff::reports
