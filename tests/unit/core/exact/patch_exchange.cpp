#include "core/exact/exact.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"
#include "tests/unit/core/geometry/rectangles.hpp"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace ff {
namespace {

using Eigen::Vector3d;

Surface turned(const Surface& surface) {
    const Eigen::AngleAxisd turn(0.7, Vector3d(1, 2, 3).normalized());
    const Parallelogram& shape = parallelogram(surface);
    return {Parallelogram{turn * shape.corner, turn * shape.edge_u, turn * shape.edge_v}, turn * surface.normal,
            surface.face};
}

Surface turned_edges(Surface surface) {
    Parallelogram& shape = parallelogram(surface);
    shape.corner += shape.edge_u;
    const Vector3d edge = shape.edge_u;
    shape.edge_u = shape.edge_v;
    shape.edge_v = -edge;
    return surface;
}

/// Every entry against the pair that it stands for, computed by itself.
void expect_every_pair(const Surface& from, const Surface& to, const PatchExchange& exchange, Subdivision m) {
    ASSERT_EQ(exchange.areas.rows(), m.of(from).parts());
    ASSERT_EQ(exchange.areas.cols(), m.of(to).parts());
    for (std::uint32_t i = 0; i < m.of(from).parts(); ++i) {
        for (std::uint32_t j = 0; j < m.of(to).parts(); ++j) {
            const auto expected = exact_exchange_area(patch(from, m.of(from), i), patch(to, m.of(to), j));
            ASSERT_NEAR(exchange.areas(i, j), expected.value(), exchange.error) << i << " " << j;
        }
    }
}

TEST(PatchExchange, ComputesCongruentPairsOnce) {
    const Scene box = make_box(2, 1, 0.5);
    constexpr Subdivision m{4};
    const auto& s = box.surfaces;
    const auto parallel = patch_exchange(s[0], s[5], m);
    EXPECT_EQ(parallel.computed, 49u);  // (2m-1)^2
    expect_every_pair(s[0], s[5], parallel, m);
    const auto adjacent = patch_exchange(s[0], s[1], m);
    EXPECT_EQ(adjacent.computed, 112u);  // (2m-1) m^2
    expect_every_pair(s[0], s[1], adjacent, m);
    // However the edges are directed.
    for (const Surface& to : {turned_edges(s[5]), turned_edges(turned_edges(s[5])), turned_edges(s[1])}) {
        const auto directed = patch_exchange(s[0], to, m);
        EXPECT_LE(directed.computed, 112u);
        expect_every_pair(s[0], to, directed, m);
    }
}

TEST(PatchExchange, ComputesEveryPairWhereNoneAreCongruent) {
    const Surface floor = test::rectangle("0:2 0:1 0:0 +z");
    const Surface smaller = test::rectangle("0:1 0:0.5 1:1 -z");
    const auto exchange = patch_exchange(floor, smaller, {3});
    EXPECT_EQ(exchange.computed, 81u);
    expect_every_pair(floor, smaller, exchange, {3});
}

// A floor of 3 x 1 squares, and walls and a roof with other grids, so that columns and rows, and those of the two
// surfaces, cannot be confused; where patches have an edge in common, congruent pairs are computed once.
TEST(PatchExchange, UsesTheGridOfEachSurface) {
    Surface floor = test::rectangle("0:3 0:1 0:0 +z");
    Surface roof = test::rectangle("0:3 0:1 1:1 -z");
    Surface wall = test::rectangle("0:3 0:0 0:1 +y");
    floor.grid = {3, 1};
    roof.grid = {6, 2};
    wall.grid = {3, 2};
    for (const Subdivision m : {Subdivision{1}, Subdivision{2}}) {
        for (const Surface& to : {floor, roof, wall}) {
            for (const Surface& from : {floor, roof, wall}) expect_every_pair(from, to, patch_exchange(from, to, m), m);
        }
    }
    roof.grid = {3, 2};
    const auto exchange = patch_exchange(floor, roof, {1});
    expect_every_pair(floor, roof, exchange, {1});
    EXPECT_EQ(exchange.computed, 5u * 2);  // offsets of -2 to 2 columns; rows have no edge in common
}

TEST(PatchExchange, IsUnchangedByTurningTheBox) {
    const Scene box = make_box(2, 1, 0.5);
    for (const auto& [i, j] : {std::array<std::size_t, 2>{0, 5}, {0, 1}, {3, 2}}) {
        const auto level = patch_exchange(box.surfaces[i], box.surfaces[j], {3});
        const auto tilted = patch_exchange(turned(box.surfaces[i]), turned(box.surfaces[j]), {3});
        // By contour integrals; turning rounds coordinates near 2 in the last digit.
        EXPECT_LT((level.areas - tilted.areas).cwiseAbs().maxCoeff(), level.error + tilted.error + 4e-15);
        EXPECT_LT(tilted.error, 1e-13);
        EXPECT_EQ(level.computed, tilted.computed);
    }
}

TEST(PatchExchange, SumsToTheSurfaces) {
    const Scene cube = built_in_scene("cube");
    for (const std::size_t to : {1u, 5u}) {
        const auto exchange = patch_exchange(cube.surfaces[0], cube.surfaces[to], {13});
        EXPECT_NEAR(exchange.areas.sum() / 36, exact_form_factor(cube, 0, static_cast<int>(to)).value(),
                    169 * 169 * exchange.error / 36);
        EXPECT_LT(exchange.error / (36.0 / 169), 1e-12);  // what a patch's factor is off by at most
    }
}

}  // namespace
}  // namespace ff
