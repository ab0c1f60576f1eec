#include "studies/verdicts/reported/estimates_file.hpp"

#include "core/support/error.hpp"
#include "tests/support/studies.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace ff::studies::gates {
namespace {

using testing::HasSubstr;

/// A file of twelve estimates of F16 whose row 5 (line 7) is replaced by `row`.
std::string with_row(std::string_view row) {
    std::string text = "trial,quantity,estimate\n";
    for (int i = 0; i < 12; ++i)
        text += i == 5 ? fmt::format("{}\n", row) : fmt::format("{},F16,0.{}\n", i, 2000 + i * i);
    return text;
}

std::string refusal_of_estimates_file(std::string_view text) {
    return test::message_of<UserError>([&] { static_cast<void>(parse_estimates(text, "mine.csv")); });
}

TEST(EstimatesFile, ReadsRowsInTheOrderOfTrials) {
    std::string text = "estimate,trial,quantity\r\n";
    for (int i = 11; i >= 0; --i) text += fmt::format(" {}e-3 ,{},\"F,16\"\r\n{},{},other\r\n", i, i, -i, i);
    const auto file = parse_estimates(text, "mine.csv");
    ASSERT_EQ(file.series.size(), 2u);
    EXPECT_EQ(file.series[0].quantity, "F,16");
    EXPECT_EQ(file.series[0].values[3], 3e-3);
    EXPECT_EQ(file.series[0].lines[11], 2u);
    EXPECT_EQ(file.series[1].values[11], -11);
}

TEST(EstimatesFile, NamesTheWrongCell) {
    EXPECT_THAT(refusal_of_estimates_file(with_row("5,F16,")), HasSubstr("mine.csv:7:7: no estimate (an empty cell)"));
    EXPECT_THAT(refusal_of_estimates_file(with_row("5,,0.2")), HasSubstr("mine.csv:7:3: no quantity"));
    EXPECT_THAT(refusal_of_estimates_file(with_row("5,F16,0.2x")),
                HasSubstr("mine.csv:7:7: estimate = '0.2x' (not a number)"));
    EXPECT_THAT(refusal_of_estimates_file(with_row("5,F16,n/a")), HasSubstr("(not a number)"));
    for (const std::string_view text : {"nan", "inf", "-inf"})
        EXPECT_THAT(refusal_of_estimates_file(with_row(fmt::format("5,F16,{}", text))),
                    HasSubstr("(not a finite number"));
    EXPECT_THAT(refusal_of_estimates_file(with_row("5,F16,-1e200")),
                HasSubstr("mine.csv:7:7: estimate = '-1e200' (beyond 1e+75"));
    EXPECT_THAT(refusal_of_estimates_file(with_row("-5,F16,0.2")),
                HasSubstr("mine.csv:7:1: trial = '-5' (not a whole number"));
    EXPECT_THAT(refusal_of_estimates_file(with_row("5.0,F16,0.2")), HasSubstr("trial = '5.0'"));
    EXPECT_THAT(refusal_of_estimates_file(with_row("5,F16,0,2")),
                HasSubstr("mine.csv:7:1: 4 cell(s) (there are 3 columns). Numbers have"));
    EXPECT_THAT(refusal_of_estimates_file(with_row("5,F16")), HasSubstr("mine.csv:7:1: 2 cell(s)"));
}

TEST(EstimatesFile, RefusesATrialThatGivesAQuantityTwice) {
    EXPECT_THAT(refusal_of_estimates_file(with_row("3,F16,0.7")),
                HasSubstr("mine.csv:7:1: trial 3 gives 'F16' again (line 5 has it"));
}

TEST(EstimatesFile, RefusesMissingUnknownOrDuplicateColumns) {
    EXPECT_THAT(refusal_of_estimates_file(""), HasSubstr("mine.csv:1:1: the file is empty"));
    EXPECT_THAT(refusal_of_estimates_file("trial,quantity\n"), HasSubstr("mine.csv:1:1: column 'estimate' is missing"));
    EXPECT_THAT(refusal_of_estimates_file("trial,quantity,estimates\n"),
                HasSubstr("mine.csv:1:16: column 'estimates' is unknown. Did you mean 'estimate'?"));
    EXPECT_THAT(refusal_of_estimates_file("trial,trial,estimate\n"),
                HasSubstr("mine.csv:1:7: column 'trial' stands twice"));
    EXPECT_THAT(refusal_of_estimates_file("trial;quantity;estimate\n"), HasSubstr("between commas"));
    EXPECT_THAT(refusal_of_estimates_file("trial,quantity,estimate\n"), HasSubstr("no rows below the header"));
}

TEST(EstimatesFile, RefusesTooFewRows) {
    EXPECT_THAT(refusal_of_estimates_file("trial,quantity,estimate\n0,F16,0.1\n1,F16,0.2\n"),
                HasSubstr("mine.csv:3:1: 'F16' has 2 row(s)"));
}

TEST(FindSeries, SuggestsTheNearestQuantity) {
    const auto file = parse_estimates(with_row("5,F16,0.2"), "mine.csv");
    EXPECT_EQ(find_series(file, "F16", "bands.toml:3:1").values.size(), 12u);
    try {
        static_cast<void>(find_series(file, "F61", "bands.toml:3:1"));
        FAIL();
    } catch (const UserError& error) {
        EXPECT_THAT(error.what(),
                    HasSubstr("bands.toml:3:1: quantity = \"F61\" (mine.csv has no such estimates). Did you "
                              "mean 'F16'? It has: F16."));
    }
}

}  // namespace
}  // namespace ff::studies::gates
