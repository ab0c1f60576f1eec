#include "core/visibility/curtains.hpp"

#include "tests/support/unit_cube.hpp"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <numeric>
#include <optional>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;
using test::unit_cube;

/// An upright square of this half width beside an upright edge of the cube, looking at its middle.
std::vector<Vector3d> beside(double sign, double half, double height = 0.5) {
    const Vector3d middle(0.5 + sign, 0.5 + sign, height);
    const Vector3d across(half, -half, 0);
    const Vector3d up(0, 0, half);
    return {middle - across - up, middle + across - up, middle + across + up, middle - across + up};
}

bool are_hidden(const std::vector<Surface>& surfaces, const std::vector<Vector3d>& from,
                const std::vector<Vector3d>& to, bool others_are_clear = true) {
    std::vector<std::optional<Plate>> plates;
    for (const Surface& surface : surfaces) plates.emplace_back(outline(surface));
    std::vector<std::uint32_t> walls(surfaces.size());
    std::iota(walls.begin(), walls.end(), 0U);
    const SharedEdges edges(surfaces);
    const auto end = [](const std::vector<Vector3d>& corners) {
        Eigen::AlignedBox3d box;
        for (const Vector3d& corner : corners) box.extend(corner);
        return Curtains::End{corners, Vector3d::Zero(), box};
    };
    return Curtains(edges, plates).hide_all(walls, end(from), end(to), 0, [&](std::uint32_t) {
        return others_are_clear;
    });
}

// Diagonal lines enter the cube by either of two walls, and leave it by either of the two others.
TEST(Curtains, HideWhatNoneOfTheirWallsHidesAlone) {
    EXPECT_TRUE(are_hidden(unit_cube(), beside(-1, 0.1), beside(1, 0.1)));
    EXPECT_FALSE(are_hidden(unit_cube(), beside(-1, 0.1), beside(1, 0.1, 3.5))) << "some lines pass over the cube";
    EXPECT_FALSE(are_hidden(unit_cube(), beside(-1, 0.7), beside(1, 0.7))) << "some lines pass beside it";
    EXPECT_FALSE(are_hidden(unit_cube(), beside(-1, 0.1), beside(-1.5, 0.1))) << "both are on one side of it";
}

// Each pair of the two walls on either side is a curtain of its own; walls that the lines do not reach may be missing.
TEST(Curtains, NeedNotBeClosed) {
    std::vector<Surface> sides = unit_cube();
    EXPECT_TRUE(are_hidden({sides[2], sides[4]}, beside(-1, 0.1), beside(1, 0.1)));
    EXPECT_FALSE(are_hidden({sides[2]}, beside(-1, 0.1), beside(1, 0.1)));
    EXPECT_FALSE(are_hidden({sides[2], sides[5]}, beside(-1, 0.1), beside(1, 0.1))) << "no edge in common";
}

TEST(Curtains, MustNotReachAnEnd) {
    const std::vector<Surface> sides = unit_cube();
    EXPECT_TRUE(are_hidden({sides[2], sides[4]}, beside(-0.6, 0.01), beside(1, 0.1)));
    EXPECT_FALSE(are_hidden({sides[2], sides[4]}, beside(-0.5, 0.1), beside(1, 0.1))) << "it lies across their edge";
}

}  // namespace
}  // namespace ff
