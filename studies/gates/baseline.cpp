#include "studies/gates/baseline.hpp"

#include "core/support/error.hpp"
#include "studies/verdicts/gate.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace ff::studies::gates {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view schema = "ffstudy.baseline/1";

constexpr double smallest_square = smallest_magnitude * smallest_magnitude;
constexpr double largest_square = largest_magnitude * largest_magnitude;
constexpr double least_freedom = 0.5;  // the largest kurtosis that n values can have leaves more
constexpr std::int64_t most_stored_trials = 1'000'000'000'000'000;

double read_number(const Json& json, const char* key, double low) {
    const auto number = json.at(key).get<double>();
    if (!(low <= number && number <= largest_magnitude))
        throw UserError("{} = {} (not from {:g} to {:g})", key, number, low, largest_magnitude);
    return number;
}

std::int64_t read_whole(const Json& json, const char* key, std::int64_t low, std::int64_t high) {
    const auto number = json.at(key).get<double>();
    if (!(static_cast<double>(low) <= number && number <= static_cast<double>(high)) || std::floor(number) != number)
        throw UserError("{} = {} (not a whole number from {} to {})", key, number, low, high);
    return static_cast<std::int64_t>(number);
}

int read_face(const Json& json, const char* key) {
    return static_cast<int>(read_whole(json, key, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()));
}

Json skewness_json(const gate::MeanSkewness& skewness) {
    return {{"value", skewness.value}, {"error", skewness.error}};
}

/// Files of earlier versions have none.
gate::MeanSkewness read_skewness(const Json& json, std::uint64_t trials) {
    gate::MeanSkewness skewness;
    if (!json.contains("skewness")) return skewness;
    skewness.value = read_number(json.at("skewness"), "value", -largest_magnitude);
    skewness.error = read_number(json.at("skewness"), "error", 0);
    skewness.insignificant = gate::insignificant_skewness(static_cast<double>(trials));
    return skewness;
}

Json spread_json(const std::optional<StoredSpread>& spread) {
    if (!spread) return nullptr;
    Json json{{"mean_square", spread->mean_square}, {"freedom", spread->freedom}};
    if (spread->evidence) {
        json["relative_error"] = spread->evidence->standard_error / spread->mean_square;
        json["skewness"] = skewness_json(spread->evidence->skewness);
    }
    return json;
}

std::optional<StoredSpread> read_spread(const Json& json, std::uint64_t trials) {
    if (json.is_null()) return std::nullopt;
    StoredSpread spread{
        {.mean_square = json.at("mean_square").get<double>(), .freedom = json.at("freedom").get<double>(), .n = trials},
        {}};
    if (!(smallest_square <= spread.mean_square && spread.mean_square <= largest_square))
        throw UserError("mean_square = {} (not from {:g} to {:g})", spread.mean_square, smallest_square,
                        largest_square);
    if (!(least_freedom <= spread.freedom && spread.freedom <= static_cast<double>(trials)))
        throw UserError("freedom = {} (not from {} to the {} trials)", spread.freedom, least_freedom, trials);
    if (json.contains("skewness"))
        spread.evidence =
            stats::MeanEvidence{.difference = spread.mean_square,
                                .standard_error = read_number(json, "relative_error", 0) * spread.mean_square,
                                .freedom = static_cast<double>(trials) - 1,
                                .skewness = read_skewness(json, trials),
                                .method = {},
                                .n = trials};
    return spread;
}

/// A mean square about a centre, with the evidence of the same squares.
std::optional<StoredSpread> store_spread(const std::optional<stats::MeanSquare>& spread, std::span<const double> values,
                                         double centre) {
    if (!spread) return std::nullopt;
    std::vector<double> squares;
    for (const double value : values) squares.push_back((value - centre) * (value - centre));
    StoredSpread stored{*spread, stats::mean_evidence(squares, 0)};
    if (stored.evidence) stored.evidence->difference = spread->mean_square;
    return stored;
}

Json quantity_json(const StoredQuantity& stored) {
    return {{"cell", stored.cell},
            {"from", stored.quantity.from},
            {"to", stored.quantity.to},
            {"trials", stored.trials},
            {"mean", stored.mean},
            {"standard_error", stored.standard_error},
            {"skewness", skewness_json(stored.skewness)},
            {"variance", spread_json(stored.variance)},
            {"mean_square_error", spread_json(stored.mean_square_error)}};
}

StoredQuantity read_quantity(const Json& json) {
    StoredQuantity stored;
    stored.cell = json.at("cell").get<std::string>();
    stored.quantity = {QuantityKind::form_factor, read_face(json, "from"), read_face(json, "to")};
    stored.trials = static_cast<std::uint64_t>(read_whole(json, "trials", 1, most_stored_trials));
    stored.mean = read_number(json, "mean", -largest_magnitude);
    stored.standard_error = read_number(json, "standard_error", 0);
    stored.skewness = read_skewness(json, stored.trials);
    stored.variance = read_spread(json.at("variance"), stored.trials);
    stored.mean_square_error = read_spread(json.at("mean_square_error"), stored.trials);
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
    if (const auto mean = stats::mean_evidence(values, values.front())) stored.skewness = mean->skewness;
    stored.variance = store_spread(stats::mean_square_of(moments), values, stored.mean);
    if (reference)
        stored.mean_square_error = store_spread(stats::mean_square_about(values, *reference), values, *reference);
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
        if (json.at("schema") != schema) throw UserError("the schema is not {}", schema);
        Baseline baseline;
        baseline.origin = origin;
        for (const Json& gate : json.at("gates")) {
            StoredGate& stored = baseline.gates.emplace_back();
            stored.gate = gate.at("gate").get<std::string>();
            stored.seconds_per_trial = read_number(gate, "seconds_per_trial", 0);
            for (const Json& quantity : gate.at("quantities")) {
                try {
                    stored.quantities.push_back(read_quantity(quantity));
                } catch (const UserError& error) {
                    throw UserError("gate '{}', quantity {}: {}", stored.gate, stored.quantities.size() + 1,
                                    error.what());
                }
            }
        }
        return baseline;
    } catch (const nlohmann::json::exception& error) {
        throw UserError("{}: is not a baseline ({}). Write it with --save-baseline.", origin, error.what());
    } catch (const UserError& error) {
        throw UserError("{}: is not a baseline ({}). Write it with --save-baseline.", origin, error.what());
    }
}

}  // namespace ff::studies::gates
