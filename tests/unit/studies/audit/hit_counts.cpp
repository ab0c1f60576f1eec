#include "studies/audit/printed_number.hpp"

#include "tests/unit/studies/audit/formats.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ff::studies::audit {
namespace {

using test::rounded_digits;

constexpr NumberFormat truncated_digits{Rounding::truncated, Layout::significant_digits, 6};

TEST(PossibleHits, FindsTheOnlyWholeNumber) {
    // python3 -c "print(21024/105625)"  ->  0.19904378698224852
    const auto hits = possible_hits({0.1990435, 0.1990445}, 105625);
    ASSERT_TRUE(hits);
    EXPECT_EQ(hits->low, 21024);
    EXPECT_EQ(hits->high, 21024);
}

TEST(PossibleHits, IsEmptyBetweenTwoWholeNumbers) {
    // python3 -c "print(0.9726395*105625, 0.9726405*105625)"  ->  102735.047 102735.153
    EXPECT_FALSE(possible_hits({0.9726395, 0.9726405}, 105625));
}

TEST(PossibleHits, CountsAllInAWideRange) {
    EXPECT_EQ(possible_hits({0.1, 0.2}, 100)->count(), 11);
}

TEST(PossibleHits, AcceptsAnExactEnd) {
    EXPECT_EQ(possible_hits({0.5, 0.5}, 90000)->low, 45000);
    EXPECT_EQ(possible_hits({1.0, 1.0}, 9000000)->low, 9000000);
}

std::vector<SampledFigure> figures_printed(NumberFormat format, std::uint64_t rays) {
    std::vector<SampledFigure> figures;
    for (int k = 0; k < 30; ++k) {
        const double value = static_cast<double>(20000 + 37 * k) / static_cast<double>(rays);
        figures.push_back({*parse_printed(print(value, format)), rays});
    }
    return figures;
}

TEST(WeighFormats, RecognisesRoundingAndTruncation) {
    for (const NumberFormat format : {rounded_digits, truncated_digits}) {
        const auto evidence = weigh_formats(figures_printed(format, 105625), 6);
        EXPECT_EQ(evidence.front().format.rounding, format.rounding);
        EXPECT_EQ(evidence.front().whole, 30u);
        EXPECT_LT(evidence.front().chance, 1e-20);
    }
}

TEST(WeighFormats, FindsNothingInFiguresOtherThanFractions) {
    // Multiples of an irrational step: whole hits only by chance, about 0.106 of 30.
    std::vector<SampledFigure> figures;
    for (int k = 1; k <= 30; ++k) {
        figures.push_back(
            {*parse_printed(print(0.19 + 0.01 * std::fmod(k * 0.6180339887, 1.0), rounded_digits)), 105625});
    }
    for (const FormatEvidence& e : weigh_formats(figures, 6)) EXPECT_GT(e.chance, 1e-3) << describe(e.format);
}

TEST(WeighFormat, LeavesOutFiguresThatCannotFail) {
    const std::vector<SampledFigure> figures{{*parse_printed("0.999691"), 9000000},
                                             {*parse_printed("0.998789"), 90000}};
    const FormatEvidence evidence = weigh_format(figures, rounded_digits);
    EXPECT_EQ(evidence.figures, 1u);
    EXPECT_NEAR(evidence.expected, 0.09, 1e-12);
}

}  // namespace
}  // namespace ff::studies::audit
