#include "studies/form_factors/form_factors.hpp"

#include "core/geometry/scene.hpp"
#include "tests/support/studies.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace ff::studies::form_factors {
namespace {

/// Two walls of four by four tiles, a plate between them; every tile a face of its own, or two in one face.
Scene tiled_walls(bool in_pairs) {
    Scene scene;
    scene.name = scene.canonical = "tiles";
    const auto add = [&](double x, double y, double z, double size) {
        if (!in_pairs || scene.faces.empty() || scene.surfaces.size() % 2 == 0)
            scene.faces.push_back(fmt::format("f{}", scene.faces.size()));
        Surface surface;
        surface.shape = Parallelogram{{x, y, z}, {size, 0, 0}, {0, size, 0}};
        surface.normal = {0, 0, z < 1 ? 1.0 : -1.0};
        surface.face = static_cast<int>(scene.faces.size()) - 1;
        scene.surfaces.push_back(surface);
    };
    for (const double z : {0.0, 3.0}) {
        for (int i = 0; i < 80; i += 5) add(i % 4, i % 16 / 4, z, 1);  // two in a row do not touch by an edge
    }
    add(1.3, 0.8, 1.5, 1.7);
    return scene;
}

Matrix matrix_dropping(const Scene& scene, double drop) {
    Request request;
    request.tolerance = 1e-4;
    request.drop = drop;
    return find_matrix(scene, request);
}

class DroppedPairs : public testing::TestWithParam<bool> {};

TEST_P(DroppedPairs, AreSmallAndCountedInTheirRowSums) {
    const Scene scene = tiled_walls(GetParam());
    constexpr double least = 0.012;
    const Matrix whole = matrix_dropping(scene, 0);
    const Matrix part = matrix_dropping(scene, least);
    EXPECT_EQ(whole.dropped, 0u);
    ASSERT_GT(part.dropped, 10u);
    ASSERT_GT(part.exchanges.size(), 20u);
    EXPECT_EQ(part.missed(), 0u);
    EXPECT_EQ(part.exchanges.size() + part.dropped, whole.exchanges.size());
    std::vector<double> lows(part.faces(), 0);
    std::vector<double> highs(part.faces(), 0);
    for (const FaceExchange& exchange : whole.exchanges) {
        const FaceExchange kept = part.exchange(exchange.from, exchange.to);
        if (kept.high > 0) continue;
        const double smaller = std::min(whole.areas[exchange.from], whole.areas[exchange.to]);
        EXPECT_LT(exchange.low, least * smaller);
        for (const std::uint32_t face : {exchange.from, exchange.to}) {
            lows[face] += exchange.low / whole.areas[face];
            highs[face] += exchange.high / whole.areas[face];
        }
    }
    for (std::size_t face = 0; face < part.faces(); ++face) {
        const RowSum& row = part.rows[face];
        EXPECT_LE(row.dropped.low, highs[face]) << face;
        EXPECT_GE(row.dropped.high, lows[face]) << face;
        EXPECT_LE(row.low, whole.rows[face].high) << face;
        EXPECT_GE(row.high, whole.rows[face].low) << face;
        EXPECT_LE(row.dropped.value, row.value) << face;
    }
}

INSTANTIATE_TEST_SUITE_P(Faces, DroppedPairs, testing::Bool(),
                         [](const auto& faces) { return faces.param ? "OfTwoSurfaces" : "OfOneSurface"; });

TEST(PairsDroppedByGeometry, NeedNoSamples) {
    const Scene scene = tiled_walls(false);
    EXPECT_LT(matrix_dropping(scene, 0.02).samples, matrix_dropping(scene, 0).samples);
}

}  // namespace
}  // namespace ff::studies::form_factors
