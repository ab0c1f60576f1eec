#include "reports/text/text_plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ff::reports {
namespace {

using testing::HasSubstr;

TEST(TextPlot, PlacesLettersOnLogarithmicAxes) {
    const std::string plot = text_plot({{"halves", {{1, 0.1}, {10, 0.01}, {100, 0.001}}}}, 21, 3);
    EXPECT_EQ(plot,
              "  0.1 ┤a\n"
              " 0.01 ┤          a\n"
              "0.001 ┤                    a\n"
              "      └─────────────────────\n"
              "       1                 100\n"
              "       a halves\n");
}

TEST(TextPlot, MarksPlacesThatSeriesShare) {
    const std::string plot = text_plot({{"one", {{1, 1}, {4, 0.5}}}, {"two", {{1, 1}, {4, 0.25}}}}, 20, 5);
    EXPECT_THAT(plot, HasSubstr("┤*\n"));
    EXPECT_THAT(plot, HasSubstr("│                   a\n"));
    EXPECT_THAT(plot, HasSubstr("┤                   b\n"));
    EXPECT_THAT(plot, HasSubstr("  a one   b two\n"));
    EXPECT_THAT(plot, HasSubstr("  * several\n"));
}

TEST(TextPlot, ShortensLargeCounts) {
    const std::string plot = text_plot({{"x", {{360000, 0.05}, {25704900, 0.0016}}}});
    EXPECT_THAT(plot, HasSubstr(" 360000  "));
    EXPECT_THAT(plot, HasSubstr("2.57e+07\n"));
}

TEST(TextPlot, LabelsItsEndsWhereNoPowerOfTenIsNear) {
    const std::string plot = text_plot({{"x", {{64, 0.05}, {4096, 0.0016}}}});
    EXPECT_THAT(plot, HasSubstr(" 0.05 ┤a\n"));
    EXPECT_THAT(plot, HasSubstr(" 0.01 ┤"));
    EXPECT_THAT(plot, HasSubstr("0.0016 ┤"));
    EXPECT_THAT(plot, HasSubstr(" 64  "));
    EXPECT_THAT(plot, HasSubstr("4096\n"));
}

TEST(TextPlot, IsEmptyWithoutRange) {
    EXPECT_EQ(text_plot({}), "");
    EXPECT_EQ(text_plot({{"x", {{1, 0.1}, {1, 0.2}}}}), "") << "one x";
    EXPECT_EQ(text_plot({{"x", {{1, 0.1}, {2, 0.1}}}}), "") << "one y";
}

}  // namespace
}  // namespace ff::reports
