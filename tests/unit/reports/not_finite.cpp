// Infinity and NaN never reach a report as numbers.

#include "reports/csv/csv.hpp"
#include "reports/json/json.hpp"
#include "reports/markdown/markdown.hpp"
#include "reports/terminal/terminal.hpp"
#include "studies/results/results.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <limits>
#include <regex>
#include <sstream>

namespace ff::reports {
namespace {

using nlohmann::json;

/// Eight trials on a cube; of the pair 2-3, trial 5 gave `value`.
studies::Store store_with(double value) {
    return test::fill(
        test::plan_of(test::study_text("trials = 8",
                                       "[[method]]\nname = \"kernel\"\nsampler = \"random\"\n"
                                       "estimator = \"area_kernel\"\n"
                                       "samples_per_patch = 5\n")),
        [value](std::size_t, std::uint64_t trial, int from, int to) {
            const bool broken = trial == 5 && from == 2 && to == 3;
            return broken ? value
                          : 0.2 + 1e-3 * static_cast<double>((7 * trial + 3 * static_cast<std::uint64_t>(to)) % 5);
        });
}

/// Whether a text contains NaN or infinity, as printf, fmt and JSON readers spell them.
bool has_no_number(const std::string& text) {
    static const std::regex words(R"((^|[^a-z])-?(nan|inf|infinity)([^a-z]|$))", std::regex::icase);
    return std::regex_search(text, words);
}

class NotFinite : public testing::TestWithParam<double> {};

TEST_P(NotFinite, IsNullInJsonWithACountAndTheReason) {
    const studies::Store store = store_with(GetParam());
    const std::string text = results_json(studies::evaluate(store));
    EXPECT_FALSE(has_no_number(text));
    const json cell = json::parse(text).at("cells").at(0);
    std::size_t undefined = 0;
    for (const json& s : cell.at("summaries")) {
        const bool broken = (s.at("from_face") == "2" && (s.at("to_face") == "3" || s.at("to_face") == "sum")) ||
                            s.at("to_face") == "sum_re";
        EXPECT_EQ(s.at("not_finite"), broken ? 1 : 0);
        EXPECT_EQ(s.at("variance") == "undefined", broken);
        EXPECT_EQ(s.at("mean").is_null(), broken);
        EXPECT_EQ(s.at("quantiles").at("max").is_null(), broken);
        undefined += broken ? 1 : 0;
    }
    EXPECT_EQ(undefined, 3u);
    EXPECT_EQ(cell.at("bias_test").at("not_finite"), 1);
}

TEST_P(NotFinite, IsAnEmptyFieldInCsv) {
    const studies::Store store = store_with(GetParam());
    const studies::StudyResults results = studies::evaluate(store);
    std::ostringstream csv;
    write_summary_csv(csv, results.findings);
    EXPECT_FALSE(has_no_number(csv.str()));
    std::ostringstream trials;
    write_trials_csv(trials, store);
    EXPECT_FALSE(has_no_number(trials.str()));
    EXPECT_THAT(trials.str(), testing::HasSubstr(",5,2,3,\n"));
}

TEST_P(NotFinite, IsSaidInWords) {
    const studies::StudyResults results = studies::evaluate(store_with(GetParam()));
    EXPECT_FALSE(has_no_number(markdown_report(results).substr(0, 200)));
    EXPECT_THAT(terminal_summary(results), testing::HasSubstr("no number in some trials"));
}

INSTANTIATE_TEST_SUITE_P(Values, NotFinite,
                         testing::Values(std::numeric_limits<double>::infinity(),
                                         -std::numeric_limits<double>::infinity(),
                                         std::numeric_limits<double>::quiet_NaN()));

TEST(NotFiniteWords, AreRecognisedByTheseTests) {
    for (const char* text : {"1,nan,2", "a\n-inf\n", "{\"a\": Infinity}", "NaN"})
        EXPECT_TRUE(has_no_number(text)) << text;
    EXPECT_FALSE(has_no_number("not_finite, infinite, finance, null"));
}

}  // namespace
}  // namespace ff::reports
