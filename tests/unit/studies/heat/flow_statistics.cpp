#include "core/configurations/built_in_scene.hpp"
#include "core/geometry/scene.hpp"
#include "stats/basics/binomial.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "studies/heat/heat.hpp"
#include "studies/heat/sensitivity.hpp"
#include "studies/scene_files/scene_file.hpp"
#include "tests/support/known_flows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>

namespace ff::studies::heat {
namespace {

constexpr FlowIntervals statistical{.statistical = true};

form_factors::Matrix sampled(const Scene& scene, double tolerance, std::uint64_t seed, bool with_values = true) {
    form_factors::Request request;
    request.tolerance = tolerance;
    request.level_of = form_factors::LevelOf::matrix;
    request.seed = Seed{seed};
    request.randomisations = with_values;
    return form_factors::find_matrix(scene, request);
}

bool contains(const Bounds& bounds, double value) {
    return bounds.low <= value && value <= bounds.high;
}

Materials hot_and_cold(std::size_t faces) {
    Materials materials;
    for (std::size_t i = 0; i < faces; ++i) {
        Material& material = materials.faces.emplace_back();
        material.emissivity = 0.5;
        if (i < 2)
            material.temperature = i == 0 ? 300 : 400;
        else
            material.flux = 0;
    }
    return materials;
}

/// Fails by chance with 1e-6 where each interval holds with 0.95; finds a coverage of 0.5 with 0.99.
TEST(StatisticalFlows, AreCoveredAtTheirLevel) {
    const Scene scene = annulus_scene();
    const Materials materials = hot_and_cold(scene.faces.size());
    const double exact = find_flows(scene, sampled(scene, 2e-4, 1000), materials, 1).faces[1].power.middle();
    constexpr std::uint64_t seeds = 40;
    std::uint64_t held = 0;
    double width = 0, wider = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const form_factors::Matrix matrix = sampled(scene, 0.02, seed);
        const Bounds power = find_flows(scene, matrix, materials, 1, statistical).faces[1].power;
        held += contains(power, exact) ? 1U : 0U;
        width += power.half_width();
        wider += find_flows(scene, matrix, materials, 1).faces[1].power.half_width();
    }
    EXPECT_GT(stats::clopper_pearson_interval({held, seeds}, 1 - 2e-6).high, 0.95) << held;
    EXPECT_LT(2 * width, wider) << "bounds are much wider";
}

TEST(StatisticalFlows, AreKnownFromReciprocityAndClosureWhereTheseTellAll) {
    const Scene scene = make_scene(source_of_file("spheres.toml", R"(closed = true
[[surface]]
face = "outer"
shape = "sphere"
centre = [0, 0, 0]
radius = 2
facing = "inward"
[[surface]]
face = "inner"
shape = "sphere"
centre = [0.7, 0.2, 0]
radius = 1
facing = "outward"
)"));
    const Flows flows = find_flows(scene, sampled(scene, 1e-3, 1), hot_and_cold(2), 1, statistical);
    // Two faces of which the inner one sees the outer one alone: its power is that of their two resistances.
    const double inner = 4 * 3.14159265358979323846;
    const double exact =
        inner * stefan_boltzmann * (std::pow(400, 4) - std::pow(300, 4)) / (1 / 0.5 + (1 / 0.5 - 1) / 4);
    EXPECT_TRUE(flows.statistical);
    EXPECT_NEAR(flows.faces[1].power.middle(), exact, 1e-6);
    EXPECT_LT(flows.faces[1].power.half_width(), 1e-6);
    EXPECT_EQ(flows.balance.low, 0);
    EXPECT_EQ(flows.balance.high, 0);
}

// A row of adiabatic faces between two black ones, of which each sees its neighbours: the irradiation falls evenly from
// one end to the other. An iteration needs the more steps the longer the row is, and must not pass for a solution
// before.
TEST(StatisticalFlows, RestOnSolutionsOrOnNone) {
    for (const Eigen::Index n : {100, 1000, 4000}) {
        std::vector<Eigen::Triplet<double>> entries;
        for (Eigen::Index i = 0; i < n; ++i) {
            for (const Eigen::Index j : {i - 1, i + 1}) {
                if (j < 0 || j == n) continue;
                entries.emplace_back(static_cast<int>(i), static_cast<int>(j), i == 0 || i == n - 1 ? 1 : 0.5);
            }
        }
        form_factors::Matrix::Sparse factors(n, n);
        factors.setFromTriplets(entries.begin(), entries.end());
        FaceLaws laws{Eigen::VectorXd::Zero(n), Eigen::VectorXd::Ones(n), 0};
        laws.emitted[0] = 1;
        laws.reflected[0] = laws.reflected[n - 1] = 0;
        const Eigen::VectorXd zero = Eigen::VectorXd::Zero(n);
        const Eigen::VectorXd irradiation = irradiation_of(factors, zero, laws, zero);
        if (n == 100) {
            EXPECT_TRUE(irradiation.allFinite());
        }
        if (!irradiation.allFinite()) continue;
        for (Eigen::Index i = 1; i + 1 < n; ++i)
            ASSERT_NEAR(irradiation[i], 1 - static_cast<double>(i) / static_cast<double>(n - 1), 1e-5) << n << " " << i;
    }
}

// Noise gives neutral faces small powers, which must not pass for sources; the fourth root of a noisy irradiation
// bends.
TEST(StatisticalFlows, HoldForSharesAndForTemperaturesOfTinyFaces) {
    const Scene scene = make_scene(source_of_file("room.toml", R"(closed = true
[[surface]]
face = "wall"
shape = "sphere"
centre = [0, 0, 0]
radius = 2
facing = "inward"
[[surface]]
face = "lamp"
shape = "sphere"
centre = [0.7, 0.2, 0]
radius = 0.01
facing = "outward"
[[surface]]
face = "probe"
shape = "sphere"
centre = [-1, 0.3, 0]
radius = 0.002
facing = "outward"
[[surface]]
face = "bead"
shape = "sphere"
centre = [0, -1, 0.5]
radius = 0.002
facing = "outward"
)"));
    Materials materials = hot_and_cold(scene.faces.size());
    materials.faces[1].temperature = 3000;
    materials.groups = {{"lamp", {1}}, {"others", {0, 2, 3}}};
    // Wall and lamp exchange as two concentric spheres do; the probe, a point, sees the lamp as a solid angle.
    const double ratio = 1e-4 / 4;
    const double leaving = stefan_boltzmann * (std::pow(3000, 4) - std::pow(300, 4)) / (2 + ratio);
    const double of_lamp = stefan_boltzmann * std::pow(3000, 4) - leaving;
    const double of_wall = stefan_boltzmann * std::pow(300, 4) + leaving * ratio;
    const double seen = (1 - std::sqrt(1 - 1e-4 / (1.7 * 1.7 + 0.1 * 0.1))) / 2;
    const double exact = std::pow((seen * of_lamp + (1 - seen) * of_wall) / stefan_boltzmann, 0.25);
    int held = 0;
    constexpr int seeds = 10;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const Flows found = find_flows(scene, sampled(scene, 0.01, seed), materials, 1, statistical);
        ASSERT_TRUE(found.statistical);
        EXPECT_TRUE(contains(*found.groups[0].share, 1)) << seed;
        held += contains(found.faces[2].temperature, exact) ? 1 : 0;
    }
    EXPECT_GE(held, 5) << "fewer have a probability below 1e-4 where each holds with 0.95";
}

TEST(StatisticalFlows, AreWiderAllAtOnce) {
    const Scene scene = annulus_scene();
    const Materials materials = hot_and_cold(scene.faces.size());
    const form_factors::Matrix matrix = sampled(scene, 0.02, 1);
    const Flows each = find_flows(scene, matrix, materials, 1, statistical);
    const Flows all = find_flows(scene, matrix, materials, 1, {.statistical = true, .all_at_once = true});
    EXPECT_LT(1.1 * each.faces[1].power.half_width(), all.faces[1].power.half_width());
}

TEST(StatisticalFlows, AreBoundsWithoutValuesOfRandomisations) {
    const Scene scene = annulus_scene();
    const Materials materials = hot_and_cold(scene.faces.size());
    const form_factors::Matrix matrix = sampled(scene, 0.02, 1, false);
    const Flows flows = find_flows(scene, matrix, materials, 1, statistical);
    EXPECT_FALSE(flows.statistical);
    EXPECT_EQ(flows.faces[1].power.low, find_flows(scene, matrix, materials, 1).faces[1].power.low);
}

TEST(StatisticalFlows, AreAtRestBetweenFacesOfOneTemperature) {
    const Scene scene = annulus_scene();
    Materials materials = hot_and_cold(scene.faces.size());
    materials.faces[1].temperature = 300;
    EXPECT_TRUE(find_flows(scene, sampled(scene, 0.02, 1), materials, 1, statistical).are_at_rest());
}

}  // namespace
}  // namespace ff::studies::heat
