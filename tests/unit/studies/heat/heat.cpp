#include "studies/heat/heat.hpp"

#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"
#include "studies/scene_files/scene_file.hpp"
#include "tests/support/known_flows.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace ff::studies::heat {
namespace {

form_factors::Matrix factors_of(const Scene& scene, double tolerance = 1e-5, std::uint64_t seed = 1) {
    form_factors::Request request;
    request.tolerance = tolerance;
    request.level_of = form_factors::LevelOf::matrix;
    request.seed = Seed{seed};
    return form_factors::find_matrix(scene, request);
}

Flows flows_of(const Scene& scene, std::string_view materials, double tolerance = 1e-5, double scale = 1,
               std::uint64_t seed = 1) {
    return find_flows(scene, factors_of(scene, tolerance, seed), read_materials(materials, "m.toml", {scene.faces, {}}),
                      scale);
}

void expect_within(const Bounds& bounds, double value) {
    EXPECT_LE(bounds.low, value);
    EXPECT_GE(bounds.high, value);
}

double black(double kelvin) {
    return stefan_boltzmann * std::pow(kelvin, 4);
}

/// Net power from surface 1 to 2 of a two-surface enclosure in which 1 sees only 2. @see [howell]
double two_surfaces(double area1, double emissivity1, double kelvin1, double area2, double emissivity2,
                    double kelvin2) {
    return (black(kelvin1) - black(kelvin2)) /
           ((1 - emissivity1) / (emissivity1 * area1) + 1 / area1 + (1 - emissivity2) / (emissivity2 * area2));
}

TEST(HeatFlows, SumToZeroInAClosedScene) {
    const auto flows = flows_of(make_scene("cube"), R"(
[materials]
"*" = { emissivity = 0.6, temperature = 300 }
6 = { emissivity = 0.8, temperature = 800 }
)");
    double low = 0;
    double high = 0;
    for (const FaceFlow& flow : flows.faces) {
        low += flow.power.low;
        high += flow.power.high;
    }
    EXPECT_LE(low, 0);
    EXPECT_GE(high, 0);
    EXPECT_FALSE(flows.reaches_outside);
    expect_within(flows.balance, 0);
    EXPECT_LT(flows.worst, 1e-8 * flows.throughput) << "exact factors";
}

TEST(HeatFlows, AreAtRestAtOneTemperatureWhateverTheEmissivities) {
    const Scene cube = make_scene("cube");
    for (const double emissivity : {1e-9, 1e-6, 0.04, 0.05, 0.35, 1.0}) {
        for (const double kelvin : {0.0, 293.15, 1000.0, 1123.15}) {
            const auto flows =
                flows_of(cube, fmt::format("[materials]\n\"*\" = {{ emissivity = 0.9, temperature = {1} }}\n"
                                           "1 = {{ emissivity = {0}, temperature = {1} }}\n",
                                           emissivity, kelvin));
            EXPECT_TRUE(flows.are_at_rest()) << emissivity << " at " << kelvin << " K";
        }
    }
}

// 16 K apart, faces that reflect all but a billionth exchange little, which is not nothing.
TEST(HeatFlows, AreNotAtRestBetweenGoodMirrors) {
    const auto flows = flows_of(make_scene("cube"),
                                "[materials]\n\"*\" = { emissivity = 1e-9, temperature = 300 }\n"
                                "6 = { emissivity = 1e-9, temperature = 316 }\n");
    EXPECT_FALSE(flows.are_at_rest());
    EXPECT_GT(flows.faces[5].power.low, 0);
}

TEST(HeatFlows, TakeAFluxThatAWideIntervalDoesNotExclude) {
    const Scene scene = furnace_scene();
    const auto flows = flows_of(scene, R"(
[materials]
block = { emissivity = 0.8, temperature = 1200 }
roof = { emissivity = 0.6, flux = -33600 }
"*" = { emissivity = 0.9, flux = 0 }
)",
                                1e-2);
    const auto roof = static_cast<std::size_t>(std::ranges::find(scene.faces, "roof") - scene.faces.begin());
    EXPECT_EQ(flows.faces[roof].temperature.low, 0);
    EXPECT_GT(flows.faces[roof].temperature.high, 150);
    EXPECT_THROW(flows_of(scene, R"(
[materials]
block = { emissivity = 0.8, temperature = 1200 }
roof = { emissivity = 0.6, flux = -60000 }
"*" = { emissivity = 0.9, flux = 0 }
)"),
                 UserError);
}

TEST(HeatFlows, OfGroupsAreSumsOfThoseOfFaces) {
    const auto flows = flows_of(make_scene("cube"), R"(
[materials]
"*" = { emissivity = 0.6, temperature = 300 }
6 = { emissivity = 0.8, temperature = 800 }
[groups]
sides = ["1", "2", "3", "4"]
whole = "*"
)");
    ASSERT_EQ(flows.groups.size(), 2u);
    const GroupFlow& sides = flows.groups[0];
    EXPECT_EQ(sides.faces, 4u);
    EXPECT_DOUBLE_EQ(sides.area, 4 * flows.faces[0].area);
    double low = 0;
    for (std::size_t face = 0; face < 4; ++face) low += flows.faces[face].power.low;
    EXPECT_DOUBLE_EQ(sides.power.low, low);
    EXPECT_DOUBLE_EQ(sides.net().low, low / sides.area);
    ASSERT_TRUE(sides.share);
    expect_within(*sides.share, sides.power.middle() / flows.throughput);
    EXPECT_LT(sides.share->high, -0.7);
    expect_within(flows.groups[1].power, 0);
}

TEST(HeatFlows, OfGroupsHaveNoShareOfNothing) {
    const auto flows = flows_of(make_scene("cube"), "[materials]\n\"*\" = { emissivity = 0.6, temperature = 300 }\n");
    ASSERT_EQ(flows.groups.size(), 1u);
    EXPECT_FALSE(flows.groups[0].share);
}

const char* const spheres_toml = R"(
closed = true
[[surface]]
face = "inner"
shape = "sphere"
centre = [0, 0, 0]
radius = 1
facing = "outward"
[[surface]]
face = "outer"
shape = "sphere"
centre = [0, 0, 0]
radius = 2
facing = "inward"
)";

TEST(HeatFlows, ContainTheExactFlowBetweenSpheres) {
    const Scene scene = make_scene(source_of_file("spheres.toml", spheres_toml));
    const double exact = two_surfaces(4 * std::numbers::pi, 0.8, 600, 16 * std::numbers::pi, 0.5, 300);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const auto flows = flows_of(scene, R"(
[materials]
inner = { emissivity = 0.8, temperature = 600 }
outer = { emissivity = 0.5, temperature = 300 }
)",
                                    1e-3, 1, seed);
        expect_within(flows.faces[0].power, exact);
        expect_within(flows.faces[1].power, -exact);
        EXPECT_LT(flows.worst, 0.01 * flows.throughput);
    }
}

/// The matrix of the spheres as if the samples of the outer one had missed by so many half widths of their interval.
form_factors::Matrix spheres_missed_by(const Scene& scene, double half_widths) {
    form_factors::Matrix matrix = factors_of(scene, 1e-3);
    for (form_factors::FaceExchange& exchange : matrix.exchanges) {
        if (!exchange.is_sampled()) continue;
        const double miss = half_widths * (exchange.high - exchange.low) / 2;
        for (double* value : {&exchange.value, &exchange.low, &exchange.high}) *value += miss;
    }
    return matrix;
}

TEST(HeatFlows, WidenIntervalsThatMissTheSumOfARowByChance) {
    const Scene scene = make_scene(source_of_file("spheres.toml", spheres_toml));
    const auto materials = read_materials(R"(
[materials]
inner = { emissivity = 0.8, temperature = 600 }
outer = { emissivity = 0.5, temperature = 300 }
)",
                                          "m.toml", {scene.faces, {}});
    EXPECT_TRUE(find_flows(scene, spheres_missed_by(scene, 0), materials, 1).widened.empty());
    const Flows flows = find_flows(scene, spheres_missed_by(scene, 2.5), materials, 1);
    EXPECT_EQ(flows.widened, std::vector<std::size_t>{1});
    expect_within(flows.faces[0].power, two_surfaces(4 * std::numbers::pi, 0.8, 600, 16 * std::numbers::pi, 0.5, 300));
    EXPECT_THROW(find_flows(scene, spheres_missed_by(scene, 10), materials, 1), ImpossibleRow);
}

TEST(HeatFlows, RecoverTheTemperatureFromItsFlux) {
    const Scene scene = make_scene(source_of_file("spheres.toml", spheres_toml));
    const double exact = two_surfaces(4 * std::numbers::pi, 0.8, 600, 16 * std::numbers::pi, 0.5, 300);
    const auto flows = flows_of(scene, fmt::format(R"(
[materials]
inner = {{ emissivity = 0.8, flux = {:.17g} }}
outer = {{ emissivity = 0.5, temperature = 300 }}
)",
                                                   exact / (4 * std::numbers::pi)));
    expect_within(flows.faces[0].temperature, 600);
    expect_within(flows.faces[1].power, -exact);
}

// Between two concentric spheres: what the inner one emits, the outer absorbs unless it is sent back. @see [howell]
TEST(GebhartFactors, ContainTheExactOnesBetweenSpheres) {
    const Scene scene = make_scene(source_of_file("spheres.toml", spheres_toml));
    const auto materials = read_materials(R"(
[materials]
inner = { emissivity = 0.8, flux = 0 }
outer = { emissivity = 0.5, temperature = 300 }
)",
                                          "m.toml", {scene.faces, {}});
    const auto factors = find_gebhart_factors(scene, factors_of(scene, 1e-3), materials);
    ASSERT_EQ(factors.size(), 4u);
    // b11 = F12 r2 b21, b21 = F21 (e1 + r1 b11) + F22 r2 b21 with F12 = 1, F21 = 1/4, F22 = 3/4:
    // b21 = 0.25 * 0.8 / (1 - 0.75 * 0.5 - 0.25 * 0.2 * 0.5) = 1/3, b11 = 1/6
    expect_within(factors[0].gebhart, 1. / 6);
    expect_within(factors[1].gebhart, 5. / 6);
    expect_within(factors[2].gebhart, 1. / 3);
    expect_within(factors[3].gebhart, 2. / 3);
    expect_within(factors[1].script_f, 0.8 * 5. / 6);
    for (const GebhartFactor& factor : factors) EXPECT_LT(factor.gebhart.half_width(), 0.01);
}

TEST(GebhartFactors, IncludeTheSurroundingsOfAnOpenScene) {
    const Scene scene = make_scene(source_of_file("plate.toml", R"(
[[surface]]
face = "plate"
shape = "disc"
centre = [0, 0, 0]
normal = [0, 0, 1]
radius = 1
)"));
    const auto materials = read_materials("surroundings = 300\n[materials]\nplate = { emissivity = 0.5, flux = 9 }\n",
                                          "m.toml", {scene.faces, {}});
    const auto factors = find_gebhart_factors(scene, factors_of(scene), materials);
    ASSERT_EQ(factors.size(), 2u);
    expect_within(factors[0].gebhart, 0);
    EXPECT_EQ(factors[1].to, 1u);
    expect_within(factors[1].gebhart, 1);
}

TEST(HeatFlows, ScaleWithTheSquareOfTheUnit) {
    const Scene scene = make_scene("cube");
    const char* const materials =
        "[materials]\n\"*\" = { emissivity = 0.9, temperature = 300 }\n1 = { emissivity = 0.9, temperature = 400 }\n";
    const auto metres = flows_of(scene, materials);
    const auto millimetres = flows_of(scene, materials, 1e-5, 1e-3);
    EXPECT_NEAR(millimetres.faces[0].power.middle() / metres.faces[0].power.middle(), 1e-6, 1e-15);
    EXPECT_DOUBLE_EQ(millimetres.faces[0].net.middle(), metres.faces[0].net.middle());
}

const char* const plate_toml = R"(
[[surface]]
face = "plate"
shape = "disc"
centre = [0, 0, 0]
normal = [0, 0, 1]
radius = 1
)";

TEST(HeatFlows, ReachTheSurroundingsOfAnOpenScene) {
    const Scene scene = make_scene(source_of_file("plate.toml", plate_toml));
    const auto flows =
        flows_of(scene, "surroundings = 300\n[materials]\nplate = { emissivity = 0.7, temperature = 500 }\n");
    const double exact = std::numbers::pi * 0.7 * (black(500) - black(300));
    expect_within(flows.faces[0].power, exact);
    ASSERT_TRUE(flows.reaches_outside);
    expect_within(flows.balance, exact);
    EXPECT_THROW(flows_of(scene, "[materials]\nplate = { emissivity = 0.7, temperature = 500 }\n"), UserError);
}

TEST(HeatFlows, MatchTheRadiositySystemForLight) {
    const auto flows = flows_of(
        make_scene("cube"), "[materials]\n\"*\" = { reflectance = 0.5 }\n6 = { reflectance = 0.5, emission = 1 }\n");
    // All light is absorbed: half of what arrives at each face.
    double absorbed = 0;
    for (const FaceFlow& flow : flows.faces) absorbed += 0.5 * flow.irradiation.middle() * flow.area;
    EXPECT_NEAR(absorbed, 36, 1e-6);
}

TEST(HeatFlows, VanishBetweenFacesOfOneTemperature) {
    const char* const alike = "[materials]\n\"*\" = { emissivity = 0.7, temperature = 600 }\n";
    const auto rest = flows_of(furnace_scene(), alike, 1e-3);
    EXPECT_TRUE(rest.are_at_rest());
    EXPECT_TRUE(rest.within({1e-6}));
    for (const FaceFlow& face : rest.faces) expect_within(face.power, 0);
    EXPECT_TRUE(flows_of(make_scene("cube"), alike).are_at_rest());
    const std::string nearly = std::string(alike) + "block = { emissivity = 0.7, temperature = 600.001 }\n";
    EXPECT_FALSE(flows_of(furnace_scene(), nearly, 1e-3).are_at_rest());
}

TEST(HeatFlows, AreRefusedForAnAdiabaticEnclosure) {
    const auto refusal = [](const char* materials) {
        try {
            flows_of(make_scene("cube"), materials);
        } catch (const UserError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    EXPECT_THAT(refusal("[materials]\n\"*\" = { emissivity = 0.5, flux = 0 }\n"), testing::HasSubstr("no temperature"));
    EXPECT_THAT(
        refusal(
            "[materials]\n\"*\" = { emissivity = 0.5, temperature = 300 }\n1 = { emissivity = 0.5, flux = -1e4 }\n"),
        testing::HasSubstr("can absorb at most 0 W/m²"));
}

}  // namespace
}  // namespace ff::studies::heat
