#include "tests/support/known_flows.hpp"

#include "core/geometry/scene.hpp"
#include "stats/basics/binomial.hpp"
#include "tests/references/furnace_walks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numbers>
#include <vector>

namespace ff::studies::heat {
namespace {

template <class Factor>
void expect_closed_and_reciprocal(Factor factor, const std::vector<double>& areas) {
    const auto n = static_cast<int>(areas.size());
    const auto area = [&](int i) { return areas[static_cast<std::size_t>(i)]; };
    for (int i = 0; i < n; ++i) {
        double sum = 0;
        for (int j = 0; j < n; ++j) {
            sum += factor(i, j);
            EXPECT_NEAR(area(i) * factor(i, j), area(j) * factor(j, i), 1e-14) << i << " " << j;
        }
        EXPECT_NEAR(sum, 1, 1e-15);
    }
}

TEST(KnownFlows, ComeFromClosedAndReciprocalFactors) {
    expect_closed_and_reciprocal(cube_factor, std::vector<double>(6, 1));
    expect_closed_and_reciprocal(annulus_factor, {4, 8, 3, 3});
    EXPECT_NEAR(cube_factor(0, 5), 0.199824895698387, 1e-15) << "ffstudy explain cube";
}

TEST(KnownFlows, AgreeWithRaysInAnAnnulus) {
    const Scene scene = annulus_scene();
    form_factors::Request request;
    request.tolerance = 1e-3;
    request.level = 1 - 1e-6;
    request.level_of = form_factors::LevelOf::matrix;
    for (const form_factors::FaceExchange& pair : form_factors::find_matrix(scene, request).exchanges) {
        const double known = annulus_factor(static_cast<int>(pair.from), static_cast<int>(pair.to));
        const double area = std::array<double, 4>{4, 8, 3, 3}.at(pair.from) * std::numbers::pi;
        EXPECT_LE(pair.low, known * area + 1e-12) << pair.from << " " << pair.to;
        EXPECT_GE(pair.high, known * area - 1e-12) << pair.from << " " << pair.to;
    }
}

// Fails by chance with probability 1e-6, and finds a share of walks that is off by 0.006 with probability 0.99.
TEST(KnownFlows, AgreeWithRandomWalksInTheFurnace) {
    constexpr std::uint64_t walks = 250'000;
    const std::uint64_t to_roof = test::FurnaceWalks(5).to_roof(walks);
    const auto few = stats::clopper_pearson_interval({.hits = to_roof, .trials = walks}, 1 - 1e-6);
    const auto many = stats::clopper_pearson_interval(furnace_walks(), 1 - 1e-6);
    EXPECT_LE(few.low, many.high);
    EXPECT_GE(few.high, many.low);
    EXPECT_LT(furnace_power().half_width(), 2e-4 * furnace_power().middle());
}

TEST(KnownFlows, AgreeWithTheFactorsOfTheFurnace) {
    form_factors::Request request;
    request.tolerance = 1e-4;
    request.level_of = form_factors::LevelOf::matrix;
    const Scene scene = furnace_scene();
    const auto flows = find_flows(scene, form_factors::find_matrix(scene, request), furnace_materials(), 1);
    const auto block = std::find(scene.faces.begin(), scene.faces.end(), "block") - scene.faces.begin();
    const Bounds power = flows.faces[static_cast<std::size_t>(block)].power;
    EXPECT_LE(power.low, furnace_power().high);
    EXPECT_GE(power.high, furnace_power().low);
}

}  // namespace
}  // namespace ff::studies::heat
