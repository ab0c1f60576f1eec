#include "studies/form_factors/cells/blocked_pair.hpp"

#include "core/geometry/scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <vector>

namespace ff::studies::form_factors {
namespace {

using Eigen::Vector3d;
using testing::DoubleNear;
using testing::UnorderedElementsAre;

Surface plate(const Vector3d& corner, const Vector3d& u, const Vector3d& v) {
    return {Parallelogram{corner, u, v}, u.cross(v).normalized(), 0};
}

/// A square floor, a square ceiling above it, and what stands between them.
struct Room {
    Surface floor = plate({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    Surface ceiling = plate({0, 0, 1}, {0, 1, 0}, {1, 0, 0});
    std::vector<Surface> blockers;

    [[nodiscard]] BlockedPair pair() const {
        std::vector<Blocker> between;
        for (const Surface& blocker : blockers) between.emplace_back(&blocker);
        return {floor, ceiling, between};
    }
};

std::vector<double> areas(const std::vector<ConvexPolygon>& parts) {
    std::vector<double> result;
    for (const ConvexPolygon& part : parts) result.push_back(polygon_area(part));
    return result;
}

constexpr std::size_t many = 1000;

std::vector<ConvexPolygon> parts_of(const BlockedPair& pair, std::size_t most) {
    return smooth_parts(pair, rim_of(pair), most);
}

TEST(SmoothParts, AreTheWholeSourceWhereNothingChanges) {
    EXPECT_THAT(areas(parts_of(Room().pair(), many)), UnorderedElementsAre(DoubleNear(1, 1e-14)));
}

// A wide plate half-way up whose one edge runs along x = 0.4: as seen from x it hides the ceiling from 0.8 - x on,
// which is within the ceiling for x from 0 to 0.8.
TEST(SmoothParts, AreCutWhereAnEdgeMeetsACornerOfTheTarget) {
    Room room;
    room.blockers = {plate({0.4, -9, 0.5}, {9, 0, 0}, {0, 20, 0})};
    EXPECT_THAT(areas(parts_of(room.pair(), many)),
                UnorderedElementsAre(DoubleNear(0.8, 1e-12), DoubleNear(0.2, 1e-12)));
}

TEST(SmoothParts, AreCutWhereABlockerStandsOrIsSeenEdgeOn) {
    for (const double from : {0.0, 0.2}) {
        Room room;
        room.blockers = {plate({0.3, -9, from}, {0, 20, 0}, {0, 0, 0.01})};
        const BlockedPair pair = room.pair();
        double area = 0;
        for (const ConvexPolygon& part : parts_of(pair, many)) {
            const auto is_left = [&](const Vector3d& corner) { return pair.origin.x() + corner.x() <= 0.3 + 1e-9; };
            const auto is_right = [&](const Vector3d& corner) { return pair.origin.x() + corner.x() >= 0.3 - 1e-9; };
            EXPECT_TRUE(std::all_of(part.begin(), part.end(), is_left) ||
                        std::all_of(part.begin(), part.end(), is_right));
            area += polygon_area(part);
        }
        EXPECT_NEAR(area, 1, 1e-12);
    }
}

TEST(SmoothParts, AreNotCutByTheSeamOfTwoBlockers) {
    Room whole;
    whole.blockers = {plate({0.4, -9, 0.5}, {9, 0, 0}, {0, 20, 0})};
    Room halves;
    halves.blockers = {plate({0.4, -9, 0.5}, {9, 0, 0}, {0, 9.5, 0}), plate({0.4, 0.5, 0.5}, {9, 0, 0}, {0, 10.5, 0})};
    EXPECT_EQ(rim_of(whole.pair()).size(), 1u);
    EXPECT_EQ(rim_of(halves.pair()).size(), 2u) << "one piece of the same edge of each, and no seam";
    EXPECT_EQ(parts_of(halves.pair(), many).size(), parts_of(whole.pair(), many).size());
}

TEST(SmoothParts, AreEmptyWhereThereWouldBeTooMany) {
    Room room;
    room.blockers = {plate({0.2, 0.2, 0.5}, {0.3, 0.1, 0}, {0, 0.4, 0.1})};
    const std::size_t parts = parts_of(room.pair(), many).size();
    EXPECT_GT(parts, 4u);
    EXPECT_EQ(parts_of(room.pair(), parts).size(), parts);
    EXPECT_TRUE(parts_of(room.pair(), parts - 1).empty());
}

TEST(BlockedPair, EndsWhereOneIsNotInFrontOfTheOther) {
    Room room;
    room.floor = plate({0, 0, -0.5}, {1, 0, 0}, {0, 0, 1});  // seen from y < 0
    room.ceiling = plate({0, -1, 0}, {1, 0, 0}, {0, 1, 0});
    const BlockedPair pair = room.pair();
    EXPECT_NEAR(polygon_area(pair.source), 0.5, 1e-14) << "half of it is below the other";
    room.ceiling = plate({0, 1, 0}, {1, 0, 0}, {0, 1, 0});
    EXPECT_TRUE(room.pair().target.empty());
}

}  // namespace
}  // namespace ff::studies::form_factors
