#include "studies/audit/printed_number.hpp"

#include "tests/unit/studies/audit/formats.hpp"

#include <gtest/gtest.h>

namespace ff::studies::audit {
namespace {

using test::rounded_digits;

constexpr NumberFormat truncated_decimals{Rounding::truncated, Layout::fixed_decimals, 6};

Range range_of(std::string_view text, NumberFormat format) {
    return printed_range(*parse_printed(text), format).value();
}

TEST(ParsePrinted, KeepsTheNumberOfDecimals) {
    const auto number = parse_printed("1.001140");
    ASSERT_TRUE(number);
    EXPECT_EQ(number->digits, 1001140);
    EXPECT_EQ(number->decimals, 6);
    EXPECT_DOUBLE_EQ(number->value(), 1.00114);
}

TEST(ParsePrinted, RefusesAnythingButPlainNumbers) {
    for (const char* text : {"", ".", "-1", "1e-3", "1.2.3", "0,2", " 1", "12345678901234567"}) {
        EXPECT_FALSE(parse_printed(text)) << text;
    }
}

TEST(PrintedRange, IsHalfAUnitToEachSideOfARoundedNumber) {
    const Range range = range_of("0.199044", rounded_digits);
    EXPECT_NEAR(range.low, 0.1990435, 1e-15);
    EXPECT_NEAR(range.high, 0.1990445, 1e-15);
}

TEST(PrintedRange, EndsBelowTheNextNumberIfTruncated) {
    const Range range = range_of("0.199044", truncated_decimals);
    EXPECT_DOUBLE_EQ(range.low, 0.199044);
    EXPECT_GT(range.high, 0.1990449);
    EXPECT_LT(range.high, 0.199045);
}

TEST(PrintedRange, CountsSignificantDigitsFromTheFirstOne) {
    EXPECT_NEAR(range_of("1.00034", rounded_digits).high, 1.000345, 1e-15);
    EXPECT_NEAR(range_of("0.0587", rounded_digits).high, 0.05870005, 1e-15);
}

TEST(PrintedRange, IsFinerBelowAPowerOfTen) {
    const Range range = range_of("1.0", rounded_digits);
    EXPECT_NEAR(range.low, 0.9999995, 1e-15);
    EXPECT_NEAR(range.high, 1.000005, 1e-15);
}

TEST(PrintedRange, IgnoresAppendedZerosButNotOtherDigits) {
    EXPECT_TRUE(printed_range(*parse_printed("1.001140"), rounded_digits));
    EXPECT_FALSE(printed_range(*parse_printed("1.001143"), rounded_digits));
}

TEST(Print, IsInverseToPrintedRange) {
    for (const NumberFormat format : {rounded_digits, truncated_decimals}) {
        for (const char* text : {"0.199044", "0.202159", "0.058700", "0.999999"}) {
            const Range range = range_of(text, format);
            for (const double x : {range.low + 1e-9, range.middle(), range.high - 1e-9}) {
                EXPECT_DOUBLE_EQ(parse_printed(print(x, format))->value(), parse_printed(text)->value()) << x;
            }
        }
    }
}

TEST(Print, DoesNotLoseADigitToBinaryFractions) {
    EXPECT_EQ(print(0.29, {Rounding::truncated, Layout::fixed_decimals, 2}), "0.29");
}

TEST(MisprintDistance, CountsTypingErrors) {
    EXPECT_EQ(misprint_distance("0.997264", "0.997264"), 0);
    EXPECT_EQ(misprint_distance("0.97264", "0.997264"), 1);    // dropped
    EXPECT_EQ(misprint_distance("0.9972640", "0.997264"), 1);  // inserted
    EXPECT_EQ(misprint_distance("0.997224", "0.997264"), 1);   // replaced
    EXPECT_EQ(misprint_distance("0.979264", "0.997264"), 1);   // swapped
    EXPECT_EQ(misprint_distance("2.43", "1.41"), 2);
}

TEST(NumberFormat, IsDescribedInWords) {
    EXPECT_EQ(describe(rounded_digits), "rounded to 6 significant digits");
    EXPECT_EQ(describe(truncated_decimals), "truncated to 6 decimals");
}

}  // namespace
}  // namespace ff::studies::audit
