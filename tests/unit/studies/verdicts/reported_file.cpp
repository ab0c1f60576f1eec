#include "studies/verdicts/reported/reported_file.hpp"

#include "core/support/error.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>

namespace ff::studies::gates {
namespace {

using testing::HasSubstr;

ReportedFile parse(std::string_view text, StandardErrors errors = StandardErrors::required) {
    return parse_reported(text, "new.csv", errors);
}

std::string refusal_of_reported_file(std::string_view text) {
    return test::message_of<UserError>([&] { static_cast<void>(parse(text)); });
}

TEST(ParseReported, ReadsColumnsInAnyOrderAndSortsBinsAsNumbers) {
    const auto file = parse("bin,standard_error,mean,quantity,n\n10,0.1,1,a,5\n9,0.2,2,a,6\n9,0.3,3,b,7\n");
    ASSERT_EQ(file.quantities, (std::vector<std::string>{"a", "b"}));
    const auto rows = find_rows(file, "a", "bands.toml:1:1");
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(file.name_of(rows[0]), "9");
    EXPECT_EQ(rows[0].mean, 2);
    EXPECT_EQ(rows[0].standard_error, 0.2);
    EXPECT_EQ(rows[0].n, 6);
    EXPECT_EQ(rows[0].line, 3u);
    EXPECT_TRUE(file.has_errors && file.has_n && file.has_bins);
    EXPECT_FALSE(file.has_runs || file.has_cost);
}

TEST(ParseReported, TakesExactValuesWhereErrorsAreOptional) {
    EXPECT_FALSE(parse("quantity,mean\na,1\n", StandardErrors::optional).has_errors);
    EXPECT_THAT(refusal_of_reported_file("quantity,mean\na,1\n"),
                HasSubstr("new.csv:1:1: column 'standard_error' is missing"));
}

TEST(ParseReported, DistinguishesMeansFromTrialsByTheHeader) {
    EXPECT_TRUE(reports_means("quantity,mean,standard_error\n"));
    EXPECT_FALSE(reports_means("trial,quantity,estimate\n"));
}

TEST(ParseReported, RefusesImpossibleErrors) {
    const std::string header = "quantity,mean,standard_error,n\n";
    EXPECT_THAT(refusal_of_reported_file(header + "a,1,0,5\n"),
                HasSubstr("new.csv:2:5: standard_error = '0' (beside a mean of 1"));
    EXPECT_THAT(refusal_of_reported_file(header + "a,1,-1,5\n"), HasSubstr("it cannot be negative"));
    EXPECT_THAT(refusal_of_reported_file(header + "a,1,inf,5\n"), HasSubstr("not a finite number"));
    EXPECT_THAT(refusal_of_reported_file(header + "a,1,1e-80,5\n"), HasSubstr("powers cannot be computed"));
    EXPECT_THAT(refusal_of_reported_file(header + "a,1e80,1,5\n"), HasSubstr("powers cannot be computed"));
    EXPECT_THAT(refusal_of_reported_file(header + "a,1,x,5\n"), HasSubstr("not a number"));
    EXPECT_THAT(refusal_of_reported_file(header + "a,1,1,1\n"), HasSubstr("a spread needs at least 2"));
    EXPECT_THAT(refusal_of_reported_file(header + "a,1,1\n"), HasSubstr("3 cells (the header has 4)"));
    EXPECT_THAT(refusal_of_reported_file(header + "a,1,,5\n"), HasSubstr("no standard_error (an empty cell)"));
    EXPECT_EQ(refusal_of_reported_file(header + "a,0,0,5\n"), "nothing thrown");  // a bin that no sample fell into
}

TEST(ParseReported, RefusesDuplicateRows) {
    EXPECT_THAT(refusal_of_reported_file("quantity,mean,standard_error\na,1,1\nb,1,1\na,2,1\n"),
                HasSubstr("new.csv:4:1: 'a' stands here again (line 2 has it already"));
    EXPECT_THAT(refusal_of_reported_file("quantity,bin,mean,standard_error\na,x,1,1\na,y,1,1\na,x,2,1\n"),
                HasSubstr("bin x"));
    EXPECT_EQ(refusal_of_reported_file("quantity,run,mean,standard_error\na,0,1,1\na,1,1,1\n"), "nothing thrown");
}

TEST(ParseReported, RefusesAnEmptyComparison) {
    EXPECT_THAT(refusal_of_reported_file(""), HasSubstr("the file is empty"));
    EXPECT_THAT(refusal_of_reported_file("quantity,mean,standard_error\n"), HasSubstr("nothing would be compared"));
}

TEST(ParseReported, SaysHowRunsAreNumbered) {
    EXPECT_THAT(refusal_of_reported_file("quantity,mean,standard_error,run\na,1,0.1,first\n"),
                testing::EndsWith("run = 'first' (not a whole number from 0 up). Number the runs 0, 1, 2, ..."));
}

}  // namespace
}  // namespace ff::studies::gates
