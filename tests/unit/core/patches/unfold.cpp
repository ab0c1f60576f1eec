#include "core/patches/unfold.hpp"

#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace ff {
namespace {

double overlap(const FlatRectangle& a, const FlatRectangle& b) {
    const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
    const double height = std::min(a.top, b.top) - std::max(a.bottom, b.bottom);
    return std::max(0.0, width) * std::max(0.0, height);
}

double area(const FlatRectangle& r) {
    return (r.right - r.left) * (r.top - r.bottom);
}

TEST(UnfoldedBox, KeepsAreasAndOverlapsNowhere) {
    const Scene scene = make_box(3, 2, 1);
    const Subdivision subdivision{3};
    const auto box = unfold_box(scene, subdivision);
    ASSERT_TRUE(box);
    ASSERT_EQ(box->surfaces.size(), 6u);
    ASSERT_EQ(box->patches.size(), 54u);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_NEAR(area(box->surfaces[i]), ff::area(scene.surfaces[i].shape), 1e-12);
        for (std::size_t j = 0; j < i; ++j) EXPECT_NEAR(overlap(box->surfaces[i], box->surfaces[j]), 0, 1e-12);
    }
    for (std::size_t p = 0; p < box->patches.size(); ++p) {
        EXPECT_NEAR(area(box->patches[p]) * 9, area(box->surfaces[p / 9]), 1e-12);
        EXPECT_NEAR(overlap(box->patches[p], box->surfaces[p / 9]), area(box->patches[p]), 1e-12);
    }
}

TEST(UnfoldedBox, LaysAdjoiningFacesBesideTheFirst) {
    const Scene scene = make_box(1, 1, 1);
    const auto box = unfold_box(scene, {1});
    ASSERT_TRUE(box);
    EXPECT_NEAR(box->extent.right - box->extent.left, 4, 1e-12);
    EXPECT_NEAR(box->extent.top - box->extent.bottom, 3, 1e-12);
}

TEST(UnfoldedBox, IsEmptyForOtherScenes) {
    Scene scene = make_box(1, 1, 1);
    scene.empty_box.reset();
    EXPECT_FALSE(unfold_box(scene, {1}));
}

}  // namespace
}  // namespace ff
