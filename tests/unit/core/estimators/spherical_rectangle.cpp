#include "core/estimators/pairs/solid_angle.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace ff {
namespace {

/// Solid angle by the formula for a rectangle over a corner, applied four times: exact, but with few digits where the
/// rectangle is small.
double by_corners(const SeenRectangle& seen, double width, double height) {
    const auto corner = [&](double x, double y) {
        return std::atan(x * y / (seen.distance * std::sqrt(x * x + y * y + seen.distance * seen.distance)));
    };
    return corner(seen.x + width, seen.y + height) - corner(seen.x + width, seen.y) - corner(seen.x, seen.y + height) +
           corner(seen.x, seen.y);
}

// In front, to each side, across an axis, near the plane, and nearly all of the hemisphere.
constexpr auto rectangles = std::to_array<SeenRectangle>({{-1, -1, 2, 2, 1},
                                                          {1, 2, 3, 1, 0.5},
                                                          {-4, 0.1, 3, 2, 2},
                                                          {-4, -3, 2, 1, 1},
                                                          {-0.5, 1, 2, 0.3, 0.01},
                                                          {0, 0, 1, 1, 1},
                                                          {-9, -8, 17, 19, 0.1},
                                                          {2, -30, 0.01, 60, 3},
                                                          {-30, 2, 60, 0.01, 3}});

TEST(HalfSolidAngle, MatchesFourRectanglesOverACorner) {
    for (const SeenRectangle& seen : rectangles)
        EXPECT_NEAR(2 * half_solid_angle(seen), by_corners(seen, seen.width, seen.height), 1e-14);
    EXPECT_NEAR(2 * half_solid_angle({-1, -1, 2, 2, 1}), 2 * std::numbers::pi / 3, 1e-15);  // a side of a cube
}

// From far away, the solid angle is area times cosine over distance squared, with a relative error of the square of the
// width over the distance.
TEST(HalfSolidAngle, KeepsItsDigitsWhereItIsSmall) {
    const double size = 1e-5;
    const double cosine = 3 / std::sqrt(14.0);
    EXPECT_NEAR(2 * half_solid_angle({1 - size / 2, 2 - size / 2, size, size, 3}) / (size * size * cosine / 14), 1,
                1e-9);
}

// Left of the line at s lies the share s of the solid angle, and below the place at t the share t of a thin strip.
TEST(PlaceIn, PreservesSharesOfSolidAngle) {
    for (const SeenRectangle& seen : rectangles) {
        const double half_area = half_solid_angle(seen);
        for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0}) {
            const double width = place_in(seen, half_area, share, 0.5).x();
            EXPECT_NEAR(by_corners(seen, width, seen.height), share * 2 * half_area, 1e-13);
            const Eigen::Vector2d place = place_in(seen, half_area, 0.5, share);
            SeenRectangle strip{seen.x + place.x(), seen.y, 1e-7, seen.height, seen.distance};
            const double whole = half_solid_angle(strip);
            strip.height = place.y();
            EXPECT_NEAR(place.y() > 0 ? half_solid_angle(strip) / whole : 0, share, 1e-6);
        }
    }
}

// On small and far rectangles, a share of the solid angle is nearly the same share of the width and of the height: they
// differ by about the size over the distance.
TEST(PlaceIn, KeepsItsDigitsWhereTheRectangleIsSmall) {
    for (const double size : {1e-3, 1e-5, 1e-7}) {
        for (const double x : {1.0, -1.0, -size / 2}) {
            const SeenRectangle seen{x, 2, size, size, 3};
            const Eigen::Vector2d place = place_in(seen, half_solid_angle(seen), 0.25, 0.75);
            EXPECT_NEAR(place.x() / size, 0.25, size + 1e-8);
            EXPECT_NEAR(place.y() / size, 0.75, size + 1e-8);
        }
    }
}

}  // namespace
}  // namespace ff
