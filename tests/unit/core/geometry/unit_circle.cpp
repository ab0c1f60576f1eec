#include "core/geometry/unit_circle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ff {
namespace {

TEST(AngleOf, IsTheArcTangentInTheUpperHalfPlane) {
    for (int i = 0; i <= 1000; ++i) {
        const double angle = std::numbers::pi * i / 1000;
        const double sine = std::max(0.0, std::sin(angle));
        EXPECT_NEAR(angle_of(3 * sine, 3 * std::cos(angle)), std::atan2(sine, std::cos(angle)), 5e-16) << i;
    }
}

TEST(AngleOf, KeepsTheDigitsOfSmallAngles) {
    EXPECT_DOUBLE_EQ(angle_of(1e-200, 1), 1e-200);
    EXPECT_EQ(angle_of(0, 1), 0);
    EXPECT_EQ(angle_of(0, -1), std::numbers::pi);
    EXPECT_EQ(angle_of(0, 0), 0);
}

TEST(AngleOf, IsUndoneByTheUnitCircle) {
    for (const double turns : {0.0, 0.01, 0.124, 0.126, 0.25, 0.3, 0.5}) {
        const auto [cosine, sine] = unit_circle(turns);
        EXPECT_NEAR(angle_of(sine, cosine) / (2 * std::numbers::pi), turns, 2e-16);
    }
}

}  // namespace
}  // namespace ff
