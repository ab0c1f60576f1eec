#include "core/visibility/touching.hpp"

#include "core/visibility/facing.hpp"
#include "core/visibility/pair_class.hpp"
#include "tests/support/round_scenes.hpp"

#include <gtest/gtest.h>

namespace ff {
namespace {

Scene triangles() {
    // Two triangles over a common edge, and one that touches the first with a corner.
    return test::faces_of({{Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 0, 1}, 0},
                           {Triangle{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {0, 1, 0}, 0},
                           {Triangle{{0, 1, 0}, {0, 2, 1}, {0, 1.5, 1}}, {1, 0, 0}, 0}},
                          false);
}

TEST(PairClass, ClassifiesTriangles) {
    EXPECT_EQ(pair_class(triangles(), 0, 1), PairClass::adjacent);
    EXPECT_EQ(pair_class(triangles(), 0, 2), PairClass::other);
}

TEST(PairClass, FindsCommonRims) {
    const Scene can = test::closed_can();
    EXPECT_EQ(pair_class(can, 0, 1), PairClass::parallel);
    EXPECT_EQ(pair_class(can, 0, 2), PairClass::adjacent);
    EXPECT_EQ(pair_class(can, 2, 1), PairClass::adjacent);
    EXPECT_EQ(pair_class(test::closed_cone(), 0, 1), PairClass::adjacent);
    EXPECT_EQ(pair_class(test::concentric_spheres(), 0, 1), PairClass::other);
    const Scene domed = test::domed_frustum();
    EXPECT_EQ(pair_class(domed, 1, 2), PairClass::adjacent);
    EXPECT_EQ(pair_class(domed, 0, 2), PairClass::other);
}

TEST(Contact, HandlesTrianglesAndRoundShapes) {
    EXPECT_EQ(closest_contact(triangles(), 0, 1), Contact::edge);
    EXPECT_EQ(closest_contact(triangles(), 0, 2), Contact::vertex);
    EXPECT_EQ(closest_contact(test::closed_can(), 0, 2), Contact::edge);
    EXPECT_EQ(closest_contact(test::closed_can(), 0, 1), Contact::none);
}

TEST(SeesItself, HoldsForConcaveAndFoldedFaces) {
    const Scene can = test::closed_can();
    EXPECT_FALSE(sees_itself(can, 0));
    EXPECT_TRUE(sees_itself(can, 2));
    EXPECT_FALSE(sees_itself(test::concentric_spheres(), 0));
    Scene bent = triangles();
    EXPECT_FALSE(sees_itself(bent, 0));
    bent.surfaces[1].face = 0;
    EXPECT_TRUE(sees_itself(bent, 0));
}

TEST(LiesOn, RespectsRims) {
    const Surface ring = test::disc({0, 0, 0}, {0, 0, 1}, 1, 0.5);
    EXPECT_TRUE(lies_on({0.7, 0, 0}, ring, 1e-12));
    EXPECT_FALSE(lies_on({0.4, 0, 0}, ring, 1e-12));
    EXPECT_FALSE(lies_on({0.7, 0, 0.1}, ring, 1e-12));
    const Surface cap = test::sphere({0, 0, 0}, 1, Facing::inward, 0.5);
    EXPECT_TRUE(lies_on(test::tilted, cap, 1e-12));
    EXPECT_FALSE(lies_on(-test::tilted, cap, 1e-12));
}

}  // namespace
}  // namespace ff
