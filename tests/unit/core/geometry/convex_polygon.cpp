#include "core/geometry/convex_polygon.hpp"

#include "core/geometry/scene.hpp"

#include <gtest/gtest.h>

namespace ff {
namespace {

using Eigen::Vector3d;

const ConvexPolygon square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

TEST(ConvexPolygon, HasAnAreaAndDistances) {
    const Vector3d normal = twice_area(square);
    EXPECT_EQ(normal, Vector3d(0, 0, 2));
    EXPECT_EQ(polygon_area(square), 1);
    EXPECT_DOUBLE_EQ(distance({0.5, 0.5, 2}, square, normal), 2);
    EXPECT_DOUBLE_EQ(distance({4, 0.5, 4}, square, normal), 5);
    EXPECT_DOUBLE_EQ(distance({4, 5, 0}, square, normal), 5);
    EXPECT_DOUBLE_EQ(distance({0, 3, 4}, {-1, 0, 0}, {1, 0, 0}), 5);
}

TEST(ConvexPolygon, IsOutlinedCounterClockwiseAroundItsNormal) {
    const Surface above{Parallelogram{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 0, 1}};
    const Surface below{above.shape, {0, 0, -1}};
    EXPECT_EQ(outline(above), square);
    EXPECT_EQ(outline(below), ConvexPolygon(square.rbegin(), square.rend()));
    EXPECT_TRUE(outline({Disc{{0, 0, 0}, 0, 1}, {0, 0, 1}}).empty());
}

TEST(ConvexPolygon, IsClippedByAPlane) {
    EXPECT_EQ(clipped(square, {1, 0, 0}, 0.5), (ConvexPolygon{{0.5, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.5, 1, 0}}));
    EXPECT_EQ(clipped(square, {1, 1, 0}, 1.5), (ConvexPolygon{{1, 0.5, 0}, {1, 1, 0}, {0.5, 1, 0}}));
    EXPECT_EQ(clipped(square, {1, 0, 0}, 0), square) << "it touches";
    EXPECT_TRUE(clipped(square, {-1, 0, 0}, 0).empty()) << "an edge is left";
    EXPECT_TRUE(clipped(square, {1, 0, 0}, 2).empty());
}

}  // namespace
}  // namespace ff
