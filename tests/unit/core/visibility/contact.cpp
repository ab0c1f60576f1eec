#include "core/visibility/touching.hpp"

#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"

#include <gtest/gtest.h>

namespace ff {
namespace {

using Sides = std::array<Side, 4>;
constexpr Side at_low = Side::low, at_high = Side::high, at_neither = Side::neither;

const Parallelogram floor_patch{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

/// A patch of the plane y = 0 with this lower left corner.
Parallelogram wall_patch(double x, double z, double width = 1) {
    return {{x, 0, z}, {width, 0, 0}, {0, 0, 1}};
}

TEST(Contact, IsAnEdgeWhereSidesMeet) {
    const Touch touch = find_touch(floor_patch, wall_patch(0, 0));
    EXPECT_EQ(touch.contact, Contact::edge);
    EXPECT_EQ(touch.sides, (Sides{at_neither, at_low, at_neither, at_low}));
    const Touch far_sides = find_touch({{0, -1, 0}, {0, 1, 0}, {1, 0, 0}}, {{1, 0, 1}, {0, 0, -1}, {-1, 0, 0}});
    EXPECT_EQ(far_sides.sides, (Sides{at_high, at_neither, at_high, at_neither}))
        << "whichever way the coordinates run";
}

TEST(Contact, IsAnEdgeWherePartsOfSidesMeet) {
    EXPECT_EQ(find_touch(floor_patch, wall_patch(0.5, 0, 7)).contact, Contact::edge);
    EXPECT_EQ(find_touch(floor_patch, wall_patch(0.25, 0, 0.5)).contact, Contact::edge);
}

TEST(Contact, IsAVertexWhereCornersMeet) {
    const Touch touch = find_touch(floor_patch, wall_patch(1, 0));
    EXPECT_EQ(touch.contact, Contact::vertex);
    EXPECT_EQ(touch.sides, (Sides{at_high, at_low, at_low, at_low}));
}

TEST(Contact, IsAPointWhereACornerMeetsAnythingElse) {
    EXPECT_EQ(find_touch(floor_patch, {{0.5, 0, 0}, {0.5, 0, 1}, {-0.5, 0, 1}}).contact, Contact::point);
    EXPECT_EQ(find_touch({{0.5, 0, 0}, {0.5, 0, 1}, {-0.5, 0, 1}}, floor_patch).contact, Contact::point);
    EXPECT_EQ(find_touch(floor_patch, {{0.5, 0.5, 0}, {1, 0, 1}, {-1, 0, 1}}).contact, Contact::point) << "inside";
}

TEST(Contact, IsAbsentAcrossAGap) {
    EXPECT_EQ(find_touch(floor_patch, wall_patch(0, 1e-9)).contact, Contact::none);
    EXPECT_EQ(find_touch(floor_patch, wall_patch(1 + 1e-9, 0)).contact, Contact::none);
    EXPECT_EQ(find_touch(floor_patch, wall_patch(0, 5)).contact, Contact::none);
    EXPECT_EQ(find_touch(floor_patch, {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}).contact, Contact::none);
}

TEST(Contact, SurvivesRounding) {
    // Seven patches along edges of length 0.7: the corners of neighbours differ in the last bits.
    const Scene box = make_box(0.7, 0.7, 0.7);
    std::size_t edges = 0, vertices = 0;
    for (std::uint32_t i = 0; i < 49; ++i) {
        for (std::uint32_t j = 0; j < 49; ++j) {
            const Touch touch = find_touch(patch(parallelogram(box.surfaces[0]), {7, 7}, i),
                                           patch(parallelogram(box.surfaces[1]), {7, 7}, j));
            edges += touch.contact == Contact::edge;
            vertices += touch.contact == Contact::vertex;
            EXPECT_NE(touch.contact, Contact::point);
        }
    }
    EXPECT_EQ(edges, 7u);
    EXPECT_EQ(vertices, 12u);
}

TEST(ClosestContact, IsAnEdgeBetweenNeighboursInABox) {
    const Scene box = make_box(3, 2, 1);
    EXPECT_EQ(closest_contact(box, 0, 5), Contact::none);
    EXPECT_EQ(closest_contact(box, 0, 1), Contact::edge);
    EXPECT_EQ(closest_contact(box, 1, 0), Contact::edge);
}

TEST(ClosestContact, CountsOnlySurfacesThatFaceEachOther) {
    Scene halves = make_box(3, 2, 1);
    halves.surfaces[1] = halves.surfaces[0];  // two faces in one plane exchange nothing
    parallelogram(halves.surfaces[1]).corner.x() += 3;
    halves.surfaces[1].face = 1;
    EXPECT_EQ(closest_contact(halves, 0, 1), Contact::none);
}

}  // namespace
}  // namespace ff
