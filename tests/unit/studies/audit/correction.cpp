#include "studies/audit/findings.hpp"

#include "tests/unit/studies/audit/formats.hpp"

#include <gtest/gtest.h>

namespace ff::studies::audit {
namespace {

using test::rounded_digits;

constexpr auto anything = [](Range) { return true; };

TEST(Correct, RestoresADroppedDigit) {
    const Correction c = correct("0.97264", {0.997262, 0.997266}, rounded_digits, std::nullopt, anything);
    EXPECT_EQ(c.meant, "0.997264");
    EXPECT_EQ(c.edits, 1);
    EXPECT_FALSE(c.certain);
    EXPECT_NEAR(c.units, 24622, 0.5);
}

TEST(Correct, IsCertainWhenOnlyOnePrintedValueFits) {
    const Correction c = correct("0.199044", {0.19919526, 0.19919528}, rounded_digits, 105625, anything);
    EXPECT_EQ(c.meant, "0.199195");
    EXPECT_TRUE(c.certain);
    ASSERT_TRUE(c.hits);
    EXPECT_EQ(c.hits->low, 21040);
}

TEST(Correct, LooksForTheNearestMisprintInAWideRange) {
    const Correction c = correct("1.10034", {0.99, 1.01}, rounded_digits, std::nullopt, anything);
    EXPECT_EQ(c.edits, 1);
    EXPECT_TRUE(c.meant == "1.00034" || c.meant == "1.0034" || c.meant == "1.0034" || c.meant == "1.010034") << c.meant;
}

TEST(Correct, ChecksCandidatesAgainstTheRest) {
    const auto only = [](Range r) { return r.contains(1.00934); };
    const Correction c = correct("1.10034", {0.99, 1.01}, rounded_digits, std::nullopt, only);
    EXPECT_EQ(c.meant, "1.00934");
    EXPECT_EQ(c.edits, 2);
}

TEST(Correct, TakesTheTruthWhereNoMisprintExplainsAValue) {
    const Correction percent =
        correct("29.2074", {0, 1}, rounded_digits, std::nullopt, anything, Range{0.292072, 0.292074});
    EXPECT_EQ(percent.meant, "0.292073");
    const Correction hits = correct("0.150438", {0.09, 0.21}, rounded_digits, 1000, anything, Range{0.15, 0.15});
    EXPECT_EQ(hits.meant, "0.150000");
}

}  // namespace
}  // namespace ff::studies::audit
