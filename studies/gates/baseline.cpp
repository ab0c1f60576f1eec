#include "studies/gates/baseline.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace ff::studies {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view schema = "ffstudy.baseline/1";

Json spread_json(const std::optional<stats::Spread>& spread) {
    if (!spread) return nullptr;
    return {{"mean_square", spread->mean_square}, {"freedom", spread->freedom}};
}

std::optional<stats::Spread> read_spread(const Json& json, std::uint64_t trials) {
    if (json.is_null()) return std::nullopt;
    const stats::Spread spread{
        .mean_square = json.at("mean_square").get<double>(), .freedom = json.at("freedom").get<double>(), .n = trials};
    if (!(spread.mean_square > 0 && spread.freedom > 0)) throw UserError("a mean square has to be positive");
    return spread;
}

Json quantity_json(const StoredQuantity& stored) {
    return {{"cell", stored.cell},
            {"from", stored.quantity.from},
            {"to", stored.quantity.to},
            {"trials", stored.trials},
            {"mean", stored.mean},
            {"standard_error", stored.standard_error},
            {"variance", spread_json(stored.variance)},
            {"mean_square_error", spread_json(stored.mean_square_error)}};
}

StoredQuantity read_quantity(const Json& json) {
    StoredQuantity stored;
    stored.cell = json.at("cell").get<std::string>();
    stored.quantity = {QuantityKind::form_factor, json.at("from").get<int>(), json.at("to").get<int>()};
    stored.trials = json.at("trials").get<std::uint64_t>();
    stored.mean = json.at("mean").get<double>();
    stored.standard_error = json.at("standard_error").get<double>();
    stored.variance = read_spread(json.at("variance"), stored.trials);
    stored.mean_square_error = read_spread(json.at("mean_square_error"), stored.trials);
    if (!(stored.standard_error >= 0)) throw UserError("a standard error has to be 0 or more");
    return stored;
}

}  // namespace

const StoredGate* Baseline::find(std::string_view gate) const {
    const auto found = std::find_if(gates.begin(), gates.end(), [&](const StoredGate& g) { return g.gate == gate; });
    return found == gates.end() ? nullptr : &*found;
}

StoredQuantity store_quantity(std::string cell, Quantity quantity, std::span<const double> values,
                              std::optional<double> reference) {
    const auto moments = stats::moments_of(values, values.front());
    StoredQuantity stored;
    stored.cell = std::move(cell);
    stored.quantity = quantity;
    stored.trials = values.size();
    stored.mean = *moments.mean();
    stored.standard_error = moments.standard_error().value_or(0);
    stored.variance = stats::spread_of(moments);
    if (reference) stored.mean_square_error = stats::spread_about(values, *reference);
    return stored;
}

std::string baseline_json(const Baseline& baseline) {
    std::string text = fmt::format(R"({{"schema": "{}", "gates": [)", schema);
    for (const StoredGate& gate : baseline.gates) {
        text += fmt::format("{}\n {{\"gate\": {}, \"seconds_per_trial\": {}, \"quantities\": [",
                            &gate == baseline.gates.data() ? "" : ",", Json(gate.gate).dump(),
                            Json(gate.seconds_per_trial).dump());
        for (const StoredQuantity& stored : gate.quantities) {
            text += fmt::format("{}\n  {}", &stored == gate.quantities.data() ? "" : ",", quantity_json(stored).dump());
        }
        text += "]}";
    }
    return text + "]}\n";
}

Baseline parse_baseline(std::string_view text, std::string_view origin) {
    try {
        const Json json = Json::parse(text);
        if (json.at("schema") != schema) throw UserError(fmt::format("the schema is not {}", schema));
        Baseline baseline;
        baseline.origin = origin;
        for (const Json& gate : json.at("gates")) {
            StoredGate& stored = baseline.gates.emplace_back();
            stored.gate = gate.at("gate").get<std::string>();
            stored.seconds_per_trial = gate.at("seconds_per_trial").get<double>();
            for (const Json& quantity : gate.at("quantities")) stored.quantities.push_back(read_quantity(quantity));
        }
        return baseline;
    } catch (const nlohmann::json::exception& error) {
        throw UserError(fmt::format("{}: is no baseline ({}). Write it with --save-baseline.", origin, error.what()));
    } catch (const UserError& error) {
        throw UserError(fmt::format("{}: is no baseline ({}). Write it with --save-baseline.", origin, error.what()));
    }
}

}  // namespace ff::studies
