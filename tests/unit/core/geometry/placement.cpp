#include "core/geometry/placement.hpp"

#include "core/geometry/box.hpp"
#include "core/geometry/surface_map.hpp"
#include "tests/support/round_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ff {
namespace {

using Eigen::Vector3d;

Scene moved(const Scene& scene, const Vector3d& by, double scale) {
    return placed(scene, {-by / scale, 1 / scale});
}

Eigen::AlignedBox3d box_of(const Scene& scene) {
    Eigen::AlignedBox3d box;
    for (const Surface& surface : scene.surfaces) box.extend(box_around(surface));
    return box;
}

TEST(Placement, LeavesScenesNearTheOriginAsTheyAre) {
    EXPECT_TRUE(placement_of(make_box(3, 2, 1)).is_identity());
    EXPECT_TRUE(placement_of(moved(test::closed_can(), {20, -5, 3}, 1)).is_identity());
    EXPECT_TRUE(placement_of(moved(test::closed_can(), {0, 0, 0}, 1e5)).is_identity());
}

TEST(Placement, BringsFarScenesToTheOriginWithoutLosingADigit) {
    Scene far;
    far.faces = {"a"};
    const Vector3d corner(500000.125, 4600000.0078125, 3.1);
    far.surfaces.push_back({Parallelogram{corner, {4, 0, 0}, {0, 3, 0}}, {0, 0, 1}, 0});
    const Placement placement = placement_of(far);
    const Scene near = placed(far, placement);
    const Vector3d place = parallelogram(near.surfaces[0]).corner;
    EXPECT_LE(place.cwiseAbs().maxCoeff(), 8);
    EXPECT_EQ(place.z(), corner.z()) << "an axis that is not far is left alone";
    EXPECT_EQ(place + placement.origin, corner);
    EXPECT_TRUE(placement_of(near).is_identity());
}

TEST(Placement, KnowsWhichFarCoordinatesWereRounded) {
    const auto rounding_at = [](const Vector3d& corner, double edge) {
        Scene scene;
        scene.faces = {"a"};
        scene.surfaces.push_back({Parallelogram{corner, {edge, 0, 0}, {0, edge, 0}}, {0, 0, 1}, 0});
        const double rounding = rounding_of_far_coordinates(scene, placement_of(scene));
        EXPECT_EQ(placed(scene).coordinate_rounding, rounding / placement_of(scene).unit);
        return rounding;
    };
    EXPECT_EQ(rounding_at({0.1, 0.2, 0.3}, 0.7), 0) << "near";
    EXPECT_EQ(rounding_at({1e9, 1e9, 1e9 + 3}, 4), 0) << "whole numbers";
    EXPECT_EQ(rounding_at({1e7 + 0.25, 1e7, 1e7}, 0.125), 0) << "powers of two";
    EXPECT_EQ(rounding_at({1e9, 1e9, 1e9}, 0.1), 0x1p-24);
    EXPECT_EQ(rounding_at({0.5, 1e9 + 0.1, 0}, 4), 0x1p-24);
}

TEST(Placement, ScalesByAPowerOfTwo) {
    for (const double scale : {1e-30, 1e-18, 1e-7, 1e7, 1e18, 1e30}) {
        const Scene scene = moved(test::closed_can(), {0, 0, 0}, scale);
        const Placement placement = placement_of(scene);
        int exponent = 0;
        EXPECT_EQ(std::frexp(placement.unit, &exponent), 0.5);
        const double longest = box_of(placed(scene, placement)).sizes().maxCoeff();
        EXPECT_GE(longest, 1);
        EXPECT_LT(longest, 2);
    }
}

}  // namespace
}  // namespace ff
