#include "core/formulas/rectangle_formulas.hpp"

#include "core/geometry/scene.hpp"
#include "tests/unit/core/geometry/rectangles.hpp"

#include <gtest/gtest.h>

namespace ff {
namespace {

TEST(AlignedRectangle, HasAnIntervalAlongEachAxisAndASide) {
    const auto found = aligned_rectangle(test::rectangle("1:2 3:3 5:8 -y"));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->axis, 1u);
    EXPECT_EQ(found->side, -1);
    EXPECT_EQ(found->plane(), 3);
    EXPECT_EQ(found->extent[0].low, 1);
    EXPECT_EQ(found->extent[0].high, 2);
    EXPECT_EQ(found->extent[1].high, 3);
    EXPECT_EQ(found->extent[2].low, 5);
    EXPECT_EQ(found->extent[2].high, 8);
}

TEST(AlignedRectangle, OrdersTheEndsOfEdgesThatPointBackwards) {
    const auto found = aligned_rectangle({Parallelogram{{2, 0, 0}, {-3, 0, 0}, {0, 1, 0}}, {0, 0, 1}, 0});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->extent[0].low, -1);
    EXPECT_EQ(found->extent[0].high, 2);
}

TEST(AlignedRectangle, IsEmptyForOtherShapesAndOrientations) {
    const Eigen::Vector3d corner(0, 0, 0);
    const Eigen::Vector3d x(1, 0, 0);
    const Eigen::Vector3d y(0, 1, 0);
    const Eigen::Vector3d z(0, 0, 1);
    EXPECT_TRUE(aligned_rectangle({Parallelogram{corner, x, y}, z, 0}));
    EXPECT_FALSE(aligned_rectangle({Parallelogram{corner, x + y, y - x}, z, 0})) << "turned by 45 degrees";
    EXPECT_FALSE(aligned_rectangle({Parallelogram{corner, x, x + y}, z, 0})) << "slanting";
    EXPECT_FALSE(aligned_rectangle({Parallelogram{corner, x, 2 * x}, z, 0})) << "no area";
    EXPECT_FALSE(aligned_rectangle({Parallelogram{corner, x, 0 * y}, z, 0})) << "an edge of length 0";
    EXPECT_FALSE(aligned_rectangle({Parallelogram{corner, x, y}, y, 0})) << "the normal lies in the plane";
}

}  // namespace
}  // namespace ff
