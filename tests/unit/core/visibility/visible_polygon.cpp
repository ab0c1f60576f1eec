#include "core/visibility/visible_polygon.hpp"

#include "core/configurations/catalogue.hpp"
#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/visibility/occlusion.hpp"
#include "tests/support/plain_visible_polygon.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace ff {
namespace {

using Eigen::Vector3d;

Surface rectangle_at(const Vector3d& corner, const Vector3d& u, const Vector3d& v) {
    return {Parallelogram{corner, u, v}, u.cross(v).normalized(), 0};
}

/// A unit square at height 1 that faces down.
Surface ceiling() {
    return rectangle_at({0, 0, 1}, {0, 1, 0}, {1, 0, 0});
}

const Vector3d up = Vector3d::UnitZ();

TEST(VisiblePolygon, SeesAllOfAnUnoccludedPolygon) {
    // reference_configurations.csv, R12: element parallel to a unit square, corner on its normal
    const VisiblePolygon square(ceiling(), {});
    const auto factors = square.from({0, 0, 0}, up);
    EXPECT_NEAR(factors.whole, 0.138531605994893, 1e-15);
    EXPECT_EQ(factors.visible, factors.whole);
    EXPECT_EQ(square.from({0, 0, 2}, -up).whole, 0) << "from behind";
    EXPECT_EQ(square.from({0, 0, 0}, -up).whole, 0) << "below the horizon";
}

TEST(VisiblePolygon, CutsOutTheShadowExactly) {
    // From the origin, a square of side s at height 1/2 hides one of side 2 s at height 1, with a corner on the axis:
    // the factor of that one by the formula of the corner of a parallel rectangle.
    for (const double side : {0.1, 0.25, 0.4}) {
        const Surface blocker = rectangle_at({0, 0, 0.5}, {side, 0, 0}, {0, side, 0});
        const auto factors = VisiblePolygon(ceiling(), {&blocker}).from({0, 0, 0}, up);
        const double x = 2 * side;
        const double r = std::sqrt(1 + x * x);
        const double hidden = x / r * std::atan(x / r) / std::numbers::pi;
        EXPECT_NEAR(factors.whole - factors.visible, hidden, 1e-15) << side;
    }
    const Surface all = rectangle_at({0, 0, 0.5}, {0.5, 0, 0}, {0, 0.5, 0});
    EXPECT_NEAR(VisiblePolygon(ceiling(), {&all}).from({0, 0, 0}, up).visible, 0, 1e-15);
}

TEST(VisiblePolygon, CountsShadowsThatOverlapOnce) {
    const Surface left = rectangle_at({0.1, 0.1, 0.5}, {0.3, 0, 0}, {0, 0.3, 0});
    const Surface right = rectangle_at({0.2, 0.1, 0.5}, {0, 0.3, 0}, {0.3, 0, 0});
    const Surface both = rectangle_at({0.1, 0.1, 0.5}, {0.4, 0, 0}, {0, 0.3, 0});
    for (const Vector3d& place : {Vector3d(0.1, 0.2, 0), Vector3d(0.7, 0.3, 0.1), Vector3d(-0.2, 0.2, 0)}) {
        const auto two = VisiblePolygon(ceiling(), {&left, &right}).from(place, up);
        const auto one = VisiblePolygon(ceiling(), {&both}).from(place, up);
        EXPECT_NEAR(two.visible, one.visible, 1e-15);
        EXPECT_LT(one.visible, one.whole);
        EXPECT_NEAR(VisiblePolygon(ceiling(), {&right, &left}).from(place, up).visible, one.visible, 1e-15);
    }
}

TEST(VisiblePolygon, IgnoresObstaclesBehindItOrBelowTheHorizon) {
    const Surface above = rectangle_at({-1, -1, 1.5}, {3, 0, 0}, {0, 3, 0});
    const Surface below = rectangle_at({-1, -1, -0.5}, {3, 0, 0}, {0, 3, 0});
    const Surface edge_on = rectangle_at({0.3, -1, -1}, {0, 3, 0}, {0, 0, 3});
    const Vector3d place(0.3, 0.4, 0);
    for (const Surface* surface : {&above, &below, &edge_on}) {
        const auto factors = VisiblePolygon(ceiling(), {surface}).from(place, up);
        EXPECT_EQ(factors.visible, factors.whole);
    }
    // A wall that reaches through both planes hides what is beyond it.
    const Surface wall = rectangle_at({0.5, -1, -1}, {0, 3, 0}, {0, 0, 3});
    const Surface near_half = rectangle_at({0, 0, 1}, {0, 1, 0}, {0.5, 0, 0});
    EXPECT_NEAR(VisiblePolygon(ceiling(), {&wall}).from(place, up).visible,
                VisiblePolygon(near_half, {}).from(place, up).whole, 1e-15);
}

// Seen at a grazing angle, the sides of a small polygon differ by little more than rounding.
TEST(VisiblePolygon, HidesNoMoreThanTheBlockerCovers) {
    std::mt19937_64 engine(1);
    const auto draw = [&](double low, double high) { return std::uniform_real_distribution(low, high)(engine); };
    for (int trial = 0; trial < 20000; ++trial) {
        const double size = std::pow(10, draw(-7, -2));
        const Vector3d corner(draw(0, 1), draw(0, 1), std::pow(10, draw(-8, -2)));
        const double angle = draw(0, 6);
        const Surface blocker = rectangle_at(corner, size * Vector3d(std::cos(angle), std::sin(angle), 0.1),
                                             size * Vector3d(-std::sin(angle), std::cos(angle), 0));
        const Vector3d place(draw(0, 1), draw(0, 1), 0);
        const double away = (place - corner).norm() - 2 * size;
        if (away < 0) continue;
        const auto factors = VisiblePolygon(ceiling(), {&blocker}).from(place, up);
        EXPECT_LE(factors.whole - factors.visible, size * size * 1.01 / (std::numbers::pi * away * away) + 1e-13);
    }
}

// Against points on the target that core/visibility/occlusion finds visible: 40 random scenes of 4 triangles, 20000
// points each. The standard error is the sample's; |z| stays below 5 in all 40 with probability 1 - 2e-5. The hidden
// part has to be considerable in most scenes.
TEST(VisiblePolygon, AgreesWithVisiblePoints) {
    std::mt19937_64 engine(11);
    std::uniform_real_distribution<double> uniform(0, 1);
    const auto point = [&](double low, double high) {
        return Vector3d(2 * uniform(engine) - 0.5, 2 * uniform(engine) - 0.5, low + (high - low) * uniform(engine));
    };
    int partly_hidden = 0;
    for (int scene = 0; scene < 40; ++scene) {
        std::vector<Surface> blockers;
        for (int k = 0; k < 4; ++k) {
            const Triangle triangle{point(-0.2, 1.2), point(-0.2, 1.2), point(-0.2, 1.2)};
            const Vector3d across = (triangle.b - triangle.a).cross(triangle.c - triangle.a);
            blockers.push_back({triangle, across.normalized(), no_face});
        }
        std::vector<const Surface*> pointers;
        for (const Surface& blocker : blockers) pointers.push_back(&blocker);
        const Surface target = ceiling();
        const Vector3d place(uniform(engine), uniform(engine), 0);
        const Vector3d normal = Vector3d(0.4 * uniform(engine), 0.4 * uniform(engine), 1).normalized();
        const Surface source = rectangle_at(place - Vector3d(1e-9, 1e-9, 0), {1e-9, 0, 0}, {0, 1e-9, 0});
        const auto factors = VisiblePolygon(target, {pointers.begin(), pointers.end()}).from(place, normal);
        double sum = 0;
        double squares = 0;
        constexpr int points = 20000;
        for (int i = 0; i < points; ++i) {
            const Vector3d other(uniform(engine), uniform(engine), 1);
            const Vector3d apart = other - place;
            double value = std::max(0.0, apart.dot(normal)) * apart.z() /
                           (std::numbers::pi * apart.squaredNorm() * apart.squaredNorm());
            if (!sees(place, source, other, target, pointers)) value = 0;
            sum += value;
            squares += value * value;
        }
        const double mean = sum / points;
        const double error = std::sqrt((squares / points - mean * mean) / points);
        EXPECT_NEAR(mean, factors.visible, 5 * error + 1e-12) << scene;
        partly_hidden += factors.visible > 0.01 * factors.whole && factors.visible < 0.99 * factors.whole;
    }
    EXPECT_GE(partly_hidden, 20);
}

// Up to six triangles of any size near, before, behind and across the target, half of which share an edge with the one
// before them, from places that lie together: the results agree to within rounding of where edges cross.
TEST(VisiblePolygon, AgreesWithThePlainWayFromManyPlacesAtOnce) {
    std::mt19937_64 engine(12);
    std::uniform_real_distribution<double> uniform(0, 1);
    const auto point = [&] {
        return Vector3d(2 * uniform(engine) - 0.5, 2 * uniform(engine) - 0.5, 1.6 * uniform(engine) - 0.3);
    };
    int seen_in_part = 0;
    double largest = 0;
    double largest_without_last = 0;
    for (int scene = 0; scene < 2000; ++scene) {
        std::vector<Surface> blockers;
        for (int k = scene % 7; k > 0; --k) {
            const Vector3d corner = point();
            const double size = std::exp(-4 * uniform(engine));
            Triangle triangle{corner, corner + size * (point() - corner), corner + size * (point() - corner)};
            if (!blockers.empty() && uniform(engine) < 0.5) {
                const ConvexPolygon last = outline(blockers.back());
                triangle.a = last[1];
                triangle.b = last[0];
            }
            const Vector3d across = (triangle.b - triangle.a).cross(triangle.c - triangle.a);
            blockers.push_back({triangle, across.normalized(), no_face});
        }
        std::vector<Blocker> pointers;
        for (const Surface& blocker : blockers) pointers.emplace_back(&blocker);
        const Surface target = ceiling();
        const Vector3d normal = Vector3d(uniform(engine), uniform(engine), 1).normalized();
        std::vector<Vector3d> places;
        for (int k = 0; k < 1 + scene % 40; ++k) places.emplace_back(uniform(engine), uniform(engine), 0);
        std::vector<VisiblePolygon::Factors> found(places.size());
        VisiblePolygon(target, pointers).find(places, normal, found);
        const test::PlainVisiblePolygon plain(target, pointers);
        if (!pointers.empty()) pointers.pop_back();
        const test::PlainVisiblePolygon without_last(target, pointers);
        for (std::size_t k = 0; k < places.size(); ++k) {
            const auto expected = plain.from(places[k], normal);
            largest = std::max(
                {largest, std::abs(found[k].whole - expected.whole), std::abs(found[k].visible - expected.visible)});
            seen_in_part += expected.visible > 0.01 && expected.visible < 0.99 * expected.whole;
            largest_without_last = std::max(largest_without_last,
                                            std::abs(without_last.from(places[k], normal).visible - found[k].visible));
        }
    }
    EXPECT_LT(largest, 1e-12);
    EXPECT_GT(seen_in_part, 10'000);
    EXPECT_GT(largest_without_last, 0.1) << "a blocker that is missing shows";
}

// A part of a mesh around the triangle that sees the target. Cut off at its horizon where they touch, up to rounding,
// one of them left an edge of arbitrary direction, which removed the whole shadow. The second hides nothing that the
// others do not.
TEST(VisiblePolygon, IsHiddenByABodyThatTouchesTheSource) {
    const std::array<Vector3d, 8> corners{
        Vector3d(6604.71, 2614.7, 7850.55), {6813.03491651957, 3364.06511714788, 7635.84708951172},
        {7362.64, 3037.5, 7804.18},         {7133.23794291841, 3408.90402398715, 8134.99591546031},
        {7378.8, 2506.26, 8487.57},         {7605.53, 2926, 8833.2},
        {6636.24, 2936.67, 8575.66},        {6914.1828400805, 3747.03850847289, 7601.08700488357}};
    const auto triangle = [](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
        return Surface{Triangle{a, b, c}, (b - a).cross(c - a).normalized(), 0};
    };
    const auto side = [&](std::size_t a, std::size_t b, std::size_t c) {
        return triangle(corners[a], corners[b], corners[c]);
    };
    const Surface target = triangle({5000, 0, 5000}, {5000, 0, 10000}, {10000, 0, 10000});
    const Surface source = side(1, 7, 3);
    const std::array sides{side(0, 1, 2), side(1, 3, 2), side(0, 2, 4), side(2, 3, 4),
                           side(3, 5, 4), side(0, 4, 6), side(4, 5, 6)};
    std::vector<Blocker> all;
    for (const Surface& each : sides) all.emplace_back(&each);
    std::vector<Blocker> others = all;
    others.erase(others.begin() + 1);
    const SurfaceMap map(source);
    double seen = 0;
    for (int k = 0; k < 900; ++k) {
        const int row = k / 30;
        const Vector3d place = map.at((row + 0.3) / 30, (k % 30 + 0.7) / 30).position;
        const auto past_all = VisiblePolygon(target, all).from(place, source.normal);
        EXPECT_NEAR(VisiblePolygon(target, others).from(place, source.normal).visible, past_all.visible, 1e-12) << k;
        seen += past_all.visible / past_all.whole / 900;
    }
    EXPECT_GT(seen, 0.05);
    EXPECT_LT(seen, 0.2);
}

}  // namespace
}  // namespace ff
