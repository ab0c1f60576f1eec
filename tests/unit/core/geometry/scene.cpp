#include "core/geometry/scene.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/geometry/box.hpp"

#include <gtest/gtest.h>

namespace ff {
namespace {

const Parallelogram sheared{{1, 2, 3}, {4, 0, 0}, {3, 2, 0}};

TEST(Area, MatchesTheParallelogram) {
    EXPECT_DOUBLE_EQ(area(sheared), 8);
}

TEST(Patch, LiesAtItsRowAlongVAndColumnAlongU) {
    const Parallelogram found = patch(sheared, {4, 4}, 6);  // row 1, column 2 of 4 x 4
    EXPECT_EQ(found.corner, Eigen::Vector3d(1 + 2 + 0.75, 2 + 0.5, 3));
    EXPECT_EQ(found.edge_u, Eigen::Vector3d(1, 0, 0));
    EXPECT_EQ(found.edge_v, Eigen::Vector3d(0.75, 0.5, 0));
}

TEST(Patch, IsTheWholeSurfaceWhereThereIsOnlyOne) {
    const Parallelogram found = patch(sheared, undivided, 0);
    EXPECT_EQ(found.corner, sheared.corner);
    EXPECT_EQ(found.edge_u, sheared.edge_u);
    EXPECT_EQ(found.edge_v, sheared.edge_v);
}

TEST(Patches, CoverTheSurfaceOnce) {
    constexpr Grid grid{7, 7};
    double sum = 0;
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
    for (std::uint32_t index = 0; index < grid.parts(); ++index) {
        const Parallelogram piece = patch(sheared, grid, index);
        sum += area(piece);
        centroid += (piece.corner + (piece.edge_u + piece.edge_v) / 2) / 49;
    }
    EXPECT_NEAR(sum, 8, 1e-14);
    EXPECT_LT((centroid - Eigen::Vector3d(4.5, 3, 3)).norm(), 1e-14);
}

TEST(Subdivision, CountsPatchesOfASceneSurfaceBySurface) {
    EXPECT_EQ(Subdivision{13}.per_part(), 169u);
    EXPECT_EQ(Subdivision{13}.patches(built_in_scene("cube")), 1014u);
}

TEST(FaceArea, SumsOverTheSurfacesOfTheFace) {
    Scene box = make_box(2, 3, 5);
    EXPECT_EQ(face_area(box, 0), 6);
    EXPECT_EQ(face_area(box, 1), 10);
    EXPECT_EQ(face_area(box, 3), 15);
    box.surfaces[5].face = 0;
    EXPECT_EQ(face_area(box, 0), 12);
    EXPECT_EQ(face_area(box, 5), 0);
}

}  // namespace
}  // namespace ff
