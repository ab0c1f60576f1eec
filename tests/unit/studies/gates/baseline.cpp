#include "studies/gates/baseline.hpp"

#include "core/support/error.hpp"
#include "stats/variances/variance_interval.hpp"
#include "tests/support/studies.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <string>

namespace ff::studies::gates {
namespace {

using testing::HasSubstr;

constexpr std::string_view sound_quantity = R"({"cell": "c", "from": 1, "to": 2, "trials": 100, "mean": 0.2,
 "standard_error": 0.001, "variance": {"mean_square": 1e-6, "freedom": 90.5}, "mean_square_error": null})";

std::string refusal_of_baseline(std::string_view from, std::string_view to) {
    std::string quantity(sound_quantity);
    if (!from.empty()) quantity.replace(quantity.find(from), from.size(), to);
    const std::string text =
        fmt::format(R"({{"schema": "ffstudy.baseline/1", "gates": [{{"gate": "g", "seconds_per_trial": 0.1,
 "quantities": [{}, {}]}}]}})",
                    sound_quantity, quantity);
    return test::message_of<UserError>([&] { static_cast<void>(parse_baseline(text, "base.json")); });
}

TEST(ParseBaseline, NamesTheGateTheQuantityAndTheImpossibleNumber) {
    EXPECT_EQ(refusal_of_baseline("", ""), "nothing thrown");
    EXPECT_THAT(
        refusal_of_baseline("90.5", "1e308"),
        HasSubstr("base.json: is not a baseline (gate 'g', quantity 2: freedom = 1e+308 (not from 0.5 to the 100 "
                  "trials)). Write it with --save-baseline."));
    EXPECT_THAT(refusal_of_baseline("90.5", "1e-9"), HasSubstr("freedom = 1e-09"));
    EXPECT_THAT(refusal_of_baseline("1e-6", "1e308"), HasSubstr("mean_square = 1e+308"));
    EXPECT_THAT(refusal_of_baseline("1e-6", "5e-324"), HasSubstr("mean_square"));
    EXPECT_THAT(refusal_of_baseline("1e-6", "-1"), HasSubstr("mean_square"));
    EXPECT_THAT(refusal_of_baseline("0.2", "1e308"), HasSubstr("mean = 1e+308"));
    EXPECT_THAT(refusal_of_baseline("0.001", "-1"), HasSubstr("standard_error = -1"));
    EXPECT_THAT(refusal_of_baseline("\"trials\": 100", "\"trials\": 0"), HasSubstr("trials = 0"));
    EXPECT_THAT(refusal_of_baseline("\"trials\": 100", "\"trials\": 1e30"), HasSubstr("trials = 1e+30"));
    EXPECT_THAT(refusal_of_baseline("\"trials\": 100", "\"trials\": 1.5"), HasSubstr("trials = 1.5 (not a whole"));
    EXPECT_THAT(refusal_of_baseline("\"to\": 2", "\"to\": 6e19"), HasSubstr("to = 6e+19"));
}

TEST(StoredQuantity, KeepsHowSkewedItsTrialsAre) {
    const std::vector<double> values{1, 2, 2, 3, 3, 3, 4, 5, 7, 12};
    const auto stored = store_quantity("c", {QuantityKind::form_factor, 1, 2}, values, 4.0);
    const Baseline read = parse_baseline(baseline_json({"", {{"g", 0.1, {stored}}}}), "base.json");
    const StoredQuantity& back = read.gates[0].quantities[0];
    const auto mean = *stats::mean_evidence(values, 0);
    EXPECT_DOUBLE_EQ(back.skewness.value, mean.skewness.value);
    EXPECT_DOUBLE_EQ(back.skewness.error, mean.skewness.error);
    EXPECT_EQ(back.skewness.insignificant, mean.skewness.insignificant);
    for (const auto& spread : {back.variance, back.mean_square_error}) {
        ASSERT_TRUE(spread && spread->evidence);
        EXPECT_GT(spread->evidence->skewness.value, 0);
        EXPECT_GT(spread->evidence->standard_error, 0);
    }
}

TEST(StoredQuantity, HasNoSkewnessInFilesOfEarlierVersions) {
    const Baseline read = parse_baseline(
        fmt::format(R"({{"schema": "ffstudy.baseline/1", "gates": [{{"gate": "g", "seconds_per_trial": 0.1,
 "quantities": [{}]}}]}})",
                    sound_quantity),
        "base.json");
    EXPECT_EQ(read.gates[0].quantities[0].skewness.error, 0);
    EXPECT_FALSE(read.gates[0].quantities[0].variance->evidence);
}

}  // namespace
}  // namespace ff::studies::gates
