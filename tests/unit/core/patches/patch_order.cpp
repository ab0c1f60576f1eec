#include "core/patches/patch_order.hpp"

#include "core/exact/exact.hpp"
#include "core/patches/unfold.hpp"
#include "tests/support/gridded_rooms.hpp"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace ff {
namespace {

TEST(PatchOrder, NumbersSurfaceBySurfaceAndRowByRow) {
    const Scene room = test::gridded_room();
    const Subdivision subdivision{3};
    const PatchOrder order(room, subdivision);
    EXPECT_EQ(order.size(), 9u * (4 + 6 + 1 + 2 + 3 + 4));
    EXPECT_EQ(order.size(), subdivision.patches(room));
    std::uint32_t next = 0;
    for (std::uint32_t surface = 0; surface < 6; ++surface) {
        const Grid grid = room.surfaces[surface].grid;
        EXPECT_EQ(order.first(surface), next);
        EXPECT_EQ(order.count(surface), 9 * grid.columns * grid.rows);
        for (std::uint32_t row = 0; row < 3 * grid.rows; ++row) {
            for (std::uint32_t column = 0; column < 3 * grid.columns; ++column) {
                const PatchPlace place = order.place(next++);
                EXPECT_EQ(place.surface, surface);
                EXPECT_EQ(place.row, row);
                EXPECT_EQ(place.column, column);
            }
        }
    }
}

TEST(PatchOrder, LeavesOutSurfacesWithoutAFaceWhereAsked) {
    Scene room = test::gridded_room();
    room.surfaces[0].face = no_face;
    room.surfaces[5].face = no_face;
    const PatchOrder order(room, {1}, Numbered::of_faces);
    EXPECT_EQ(order.size(), 6u + 1 + 2 + 3);
    EXPECT_EQ(order.count(0), 0u);
    EXPECT_EQ(order.first(1), 0u);
    EXPECT_EQ(order.place(0).surface, 1u);
    EXPECT_EQ(order.place(11).surface, 4u);
}

TEST(PatchSequences, AreOnePerPatch) {
    const Scene room = test::gridded_room();
    const PatchSequences sequences(room, {2}, Allocation::patch, 10);
    EXPECT_EQ(sequences.count(1), 24u);
    EXPECT_EQ(sequences.of(1, 23).source, 16u + 23);
    EXPECT_EQ(sequences.of(1, 23).first, 0u);
}

// One sequence for the patches that lie in the same part of the grid, each patch with points of its own; all points are
// used.
TEST(PatchSequences, AreOnePerGridPartWhereOneServesAFace) {
    const Scene room = test::gridded_room();
    const Subdivision subdivision{2};
    const PatchSequences sequences(room, subdivision, Allocation::face, 10);
    std::set<std::pair<std::uint32_t, PointIndex>> taken;
    for (std::uint32_t surface = 0; surface < 6; ++surface) {
        const Grid parts = room.surfaces[surface].grid;
        const Grid patches = subdivision.of(room.surfaces[surface]);
        EXPECT_EQ(sequences.count(surface), parts.parts());
        for (std::uint32_t patch = 0; patch < patches.parts(); ++patch) {
            const auto [source, first] = sequences.of(surface, patch);
            const std::uint32_t row = patch / patches.columns / 2;
            const std::uint32_t column = patch % patches.columns / 2;
            EXPECT_EQ(source, sequences.of(surface, 0).source + row * parts.columns + column);
            EXPECT_LT(first, 4u * 10);
            EXPECT_EQ(first % 10, 0u);
            taken.emplace(source, first);
        }
    }
    EXPECT_EQ(taken.size(), subdivision.patches(room));
    EXPECT_EQ(taken.rbegin()->first, 19u);
}

// The rectangle is cut by hand into surfaces of the same face. Patch by patch the arithmetic is the same, and so are
// the bits, except in the column of the face itself as a target, which is the sum over six.
TEST(ExactPatchToFace, IsTheSameForAGridAsForSeparateSurfaces) {
    Scene whole = test::gridded_room();
    whole.surfaces[0].grid = {3, 2};
    Scene cut = whole;
    cut.surfaces.erase(cut.surfaces.begin());
    for (std::uint32_t p = 0; p < 6; ++p)
        cut.surfaces.insert(cut.surfaces.begin() + p, patch(whole.surfaces[0], {3, 2}, p));
    const auto of_grid = exact_patch_to_face(whole, {1}).value();
    const auto of_surfaces = exact_patch_to_face(cut, {1}).value();
    ASSERT_EQ(of_grid.rows(), of_surfaces.rows());
    EXPECT_EQ(of_grid.rightCols(5), of_surfaces.rightCols(5));
    // Exchange areas are within 1e-18 of the squared extent, 21; patches have 0.5 and more: a few roundings.
    EXPECT_LT((of_grid.col(0) - of_surfaces.col(0)).cwiseAbs().maxCoeff(), 1e-15);
    EXPECT_LT((of_grid.rowwise().sum().array() - 1).abs().maxCoeff(), 1e-14);
}

TEST(UnfoldedBox, HasNoGrids) {
    Scene box = make_box(3, 2, 1);
    EXPECT_TRUE(unfold_box(box, {1}));
    box.surfaces[3].grid = {1, 2};
    EXPECT_FALSE(unfold_box(box, {1}));
}

}  // namespace
}  // namespace ff
