#include "core/exact/pair_exchange.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/configurations/catalogue.hpp"
#include "core/exact/exact.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace ff {
namespace {

PairExchange between(const char* scene_name, std::size_t from, std::size_t to) {
    static std::vector<Scene> scenes;  // blockers point into them
    scenes.reserve(64);
    scenes.push_back(built_in_scene(scene_name));
    const Scene& scene = scenes.back();
    return pair_exchange(Occluders(scene), from, to, 1e-12);
}

TEST(PairExchange, TakesTheCheapestMethodThatGeometryAllows) {
    EXPECT_EQ(between("cube", 0, 0).method, ExchangeMethod::none);
    EXPECT_EQ(between("cube", 0, 5).method, ExchangeMethod::closed_form);
    EXPECT_EQ(between("squares_at_60_degrees", 0, 1).method, ExchangeMethod::contour);
    EXPECT_EQ(between("parallel_right_triangles", 0, 1).method, ExchangeMethod::contour);
    EXPECT_EQ(between("squares_blocked", 0, 1).method, ExchangeMethod::cells);
    EXPECT_EQ(between("coaxial_discs_equal", 0, 1).method, ExchangeMethod::contour);
    EXPECT_EQ(between("coaxial_discs_equal", 0, 1).reason, ExchangeReason::round);
    EXPECT_EQ(between("cylinder_wall", 0, 0).method, ExchangeMethod::rays) << "it sees itself";
    EXPECT_EQ(between("discs_blocked", 0, 1).method, ExchangeMethod::rays);
    EXPECT_EQ(between("discs_blocked", 0, 1).reason, ExchangeReason::curved);
}

TEST(PairExchange, GivesTheUnoccludedAreaAndTheBlockers) {
    const PairExchange blocked = between("squares_blocked", 0, 1);
    ASSERT_TRUE(blocked.area);
    EXPECT_NEAR(blocked.area->value, 0.199824895698387, blocked.area->error + 1e-15);
    EXPECT_EQ(blocked.blockers.size(), 1u);
    EXPECT_FALSE(between("cylinder_wall", 0, 0).area);
}

TEST(PairExchange, UsesMorePrecisionWhereDoubleHasTooLittle) {
    // Unit squares a thousand apart: 1e-15 of the squared extent is 1e-9, the exchange area is 3e-7.
    Scene scene;
    scene.faces = {"1", "2"};
    const Surface from{Parallelogram{{0, 0, 0}, {1, 0.5, 0}, {0, 1, 0}}, {0, 0, 1}, 0};
    const Surface to{Parallelogram{{0, 0, 1000}, {0, 1, 0}, {1, 0.5, 0}}, {0, 0, -1}, 1};
    scene.surfaces = {from, to};
    const PairExchange brief = pair_exchange(Occluders(scene), 0, 1, 1);
    const PairExchange exact = pair_exchange(Occluders(scene), 0, 1, 1e-11);
    EXPECT_LT(exact.area->error, brief.area->error / 100);
    EXPECT_NEAR(exact.area->value, 1e-6 / std::numbers::pi, exact.area->error + 1e-12);
}

TEST(PairExchange, FindsBlockersInScenesOfManySurfaces) {
    // Plates one above the other that face each other in twos, and a small one between the first two.
    Scene scene;
    scene.faces = {"1"};
    for (int i = 0; i < 600; ++i) {
        const double z = i % 2 == 0 ? i : i + 0.5;
        scene.surfaces.push_back({Parallelogram{{0, 0, z}, {1, 0, 0}, {0, 1, 0}}, {0, 0, i % 2 == 0 ? 1.0 : -1.0}, 0});
    }
    scene.surfaces.push_back({Parallelogram{{0.5, 0.5, 0.5}, {0.1, 0, 0}, {0, 0.1, 0}}, {0, 0, 1}, no_face});
    const Occluders occluders(scene);
    EXPECT_EQ(pair_exchange(occluders, 0, 1, 1e-9).blockers.size(), 1u);
    EXPECT_EQ(pair_exchange(occluders, 2, 3, 1e-9).method, ExchangeMethod::closed_form);
    EXPECT_EQ(pair_exchange(occluders, 0, 3, 1e-9).method, ExchangeMethod::none) << "a plate hides all";
}

}  // namespace
}  // namespace ff
