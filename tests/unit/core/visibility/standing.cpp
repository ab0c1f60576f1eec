#include "core/visibility/standing.hpp"

#include "core/geometry/scene.hpp"
#include "tests/support/round_scenes.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;

TEST(RoundBodiesOnSurfaces, AreFoundWhereTheirCirclesLieOnAFaceThatFacesThem) {
    const Vector3d up(0, 0, 1);
    const auto found_on = [&](const Surface& ground, const Shape& body) {
        return round_bodies_on_surfaces(test::faces_of({ground, {body, Vector3d::Zero(), 0}}, false));
    };
    const std::vector<std::pair<std::uint32_t, std::uint32_t>> stands{{1, 0}};
    const Frustum cylinder{{0, 0, 0}, {0, 0, 1}, 0.5, 0.5, Facing::outward};
    const SphereZone dome{{0, 0, 0}, up, 0.5, 0, 1, Facing::outward};
    EXPECT_EQ(found_on(test::disc({0, 0, 0}, up, 2), cylinder), stands);
    EXPECT_EQ(found_on(test::disc({0, 0, 0}, up, 2), dome), stands);
    EXPECT_EQ(found_on(test::disc({0, 0, 1}, -up, 2), cylinder), stands) << "hangs from a ceiling";
    EXPECT_TRUE(found_on(test::disc({0, 0, 0}, -up, 0.5), cylinder).empty()) << "its own cap";
    EXPECT_TRUE(found_on(test::disc({0, 0, 0}, up, 2, 0.5), cylinder).empty()) << "cut out beneath it";
    EXPECT_TRUE(found_on(test::disc({0, 0, -0.1}, up, 2), cylinder).empty()) << "above it";
    EXPECT_TRUE(found_on(test::disc({3, 0, 0}, up, 2), cylinder).empty()) << "beside it";
    const Frustum pipe{{0, 0, 0}, {0, 0, 1}, 0.5, 0.5, Facing::inward};
    EXPECT_TRUE(found_on(test::disc({0, 0, 0}, up, 2), pipe).empty()) << "a pipe is open";
}

}  // namespace
}  // namespace ff
