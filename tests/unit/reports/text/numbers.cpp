#include "reports/text/numbers.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

namespace ff::reports {
namespace {

TEST(Exact, ReadsBackAsTheSameDouble) {
    for (const double value : {0.1, 1.0 / 3, 5e-324, 1e308, -0.2000437761, 1e22}) {
        EXPECT_EQ(std::strtod(exact(value).c_str(), nullptr), value) << exact(value);
    }
    EXPECT_EQ(exact(0.1), "0.1");
}

TEST(Exact, IsEmptyWithoutAFiniteValue) {
    EXPECT_EQ(exact(std::nullopt), "");
    EXPECT_EQ(exact(std::numeric_limits<double>::quiet_NaN()), "");
    EXPECT_EQ(exact(std::numeric_limits<double>::infinity()), "");
}

TEST(ToError, ShowsTheSecondSignificantDigitOfTheError) {
    EXPECT_EQ(to_error(0.19982490, 1.2e-3), "0.1998");
    EXPECT_EQ(to_error(0.19982490, 9.9e-6), "0.1998249");
    EXPECT_EQ(to_error(12.3456, 0.5), "12.35");
    EXPECT_EQ(to_error(1234.5, 30), "1234");
    EXPECT_EQ(to_error(1234.5, std::numeric_limits<double>::infinity()), "1234.5");
    EXPECT_EQ(to_error(-0.3, 24), "0") << "not -0";
}

TEST(ToError, ShowsSmallValuesWithAnExponent) {
    EXPECT_EQ(to_error(5.2213e-7, 3.4e-8), "5.22e-07");
    EXPECT_EQ(to_error(-3.38e-6, 2e-6), "-3.4e-06");
    EXPECT_EQ(to_error(3.3e-6, 2e-3), "0.0000");
}

TEST(ToError, ShowsEightDigitsWithoutAnError) {
    EXPECT_EQ(to_error(0.199824895, 0), "0.1998249");
    EXPECT_EQ(to_error(1, 0), "1");
}

TEST(WithHalfWidth, ShowsBothToTheSameDecimalPlace) {
    EXPECT_EQ(with_half_width(0.000551, 0.0003), "0.00055 ± 0.00030");
    EXPECT_EQ(with_half_width(0.00178, 0.0000996), "0.00178 ± 0.00010");
    EXPECT_EQ(with_half_width(17.3, 1.24), "17.3 ± 1.2");
    EXPECT_EQ(with_half_width(173.4, 12.4), "173 ± 12");
    EXPECT_EQ(with_half_width(1734, 124), "1734 ± 124");
    EXPECT_EQ(with_half_width(4.07e-5, 3.04e-6), "4.07e-05 ± 3.0e-06");
    EXPECT_EQ(with_half_width(0.5, 0), "0.5");
    EXPECT_EQ(with_half_width(-2e-6, 3e-6), "-0.0000020 ± 0.0000030");
}

TEST(Brief, ShowsAFewDigits) {
    EXPECT_EQ(brief(0.0123456), "0.0123");
    EXPECT_EQ(brief(7.7e-5, 2), "7.7e-05");
    EXPECT_EQ(brief(0), "0");
    EXPECT_EQ(brief(11.7, 1), "10");
    EXPECT_EQ(brief(-1934), "-1930");
    EXPECT_EQ(brief(999600), "1e+06");
}

TEST(PValue, NeverShowsZero) {
    EXPECT_EQ(p_value(0.0312), "0.031");
    EXPECT_EQ(p_value(1e-300), "< 1e-10");
    EXPECT_EQ(p_value(0), "< 1e-10");
    EXPECT_EQ(p_value(1), "1");
    EXPECT_EQ(p_text(0.0312), "p = 0.031");
    EXPECT_EQ(p_text(0), "p < 1e-10");
}

}  // namespace
}  // namespace ff::reports
