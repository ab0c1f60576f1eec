#include "core/configurations/scenes.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/configurations/catalogue.hpp"
#include "core/exact/exact.hpp"
#include "core/formulas/polygon_exchange.hpp"
#include "core/geometry/scene.hpp"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace ff {
namespace {

/// Corners of a polygon in order around its normal.
Corners<double> directed_corners(const Surface& surface) {
    Corners<double> polygon = corners(surface.shape);
    const Eigen::Vector3d around = (polygon[1] - polygon[0]).cross(polygon[2] - polygon[0]);
    if (around.dot(surface.normal) < 0) std::reverse(polygon.begin(), polygon.end());
    return polygon;
}

TEST(ConfigurationScenes, HaveTheirOwnNamesAndStreams) {
    std::set<std::string> canonical;
    for (const std::string_view name : configuration_scene_names()) {
        const Scene scene = built_in_scene(name);
        EXPECT_EQ(scene.name, name);
        EXPECT_TRUE(canonical.insert(scene.canonical).second) << name;
        for (const Surface& surface : scene.surfaces)
            EXPECT_LT(surface.face, static_cast<int>(scene.faces.size())) << name;
        for (int face = 0; face < static_cast<int>(scene.faces.size()); ++face)
            EXPECT_GT(face_area(scene, face), 0) << name;
    }
    EXPECT_EQ(canonical.size(), 23u);
    EXPECT_FALSE(configuration_scene("cube"));
}

TEST(ConfigurationScenes, HaveTheGeometryOfTheirFormulas) {
    // For flat scenes with nothing in between, formulas are compared with the contour integral over the scene itself.
    int compared = 0;
    for (const Configuration& configuration : configurations()) {
        if (configuration.scene == nullptr || configuration.occluded) continue;
        const Scene scene = configuration.scene();
        const Surface& from = scene.surfaces.front();
        const Surface& to = scene.surfaces[1];
        if (corners(from.shape).empty() || corners(to.shape).empty()) continue;
        const auto exchange = polygon_exchange_area<double>(directed_corners(from), directed_corners(to));
        EXPECT_NEAR(exchange.value / area(from.shape), static_cast<double>(configuration.exact()),
                    exchange.error / area(from.shape) + 1e-15)
            << configuration.name;
        ++compared;
    }
    EXPECT_EQ(compared, 9);
}

TEST(KnownFormFactor, FollowsByReciprocityAndClosure) {
    const Scene discs = built_in_scene("coaxial_discs_unequal");
    const double factor = known_form_factor(discs, 0, 1).value();
    EXPECT_DOUBLE_EQ(factor, 0.7639320225002103);
    EXPECT_DOUBLE_EQ(known_form_factor(discs, 1, 0).value(), factor / 4);
    EXPECT_FALSE(known_form_factor(discs, 0, 0));

    const Scene hollow = built_in_scene("concentric_spheres");
    EXPECT_DOUBLE_EQ(known_form_factor(hollow, 0, 0).value(), 0.75);
    EXPECT_DOUBLE_EQ(known_form_factor(hollow, 0, 1).value(), 0.25);
    EXPECT_DOUBLE_EQ(known_form_factor(hollow, 1, 0).value(), 1);

    const Scene cylinder = built_in_scene("cylinder_wall");
    EXPECT_DOUBLE_EQ(known_form_factor(cylinder, 0, 2).value(), (std::sqrt(2.0) - 1) / 2);
    EXPECT_DOUBLE_EQ(known_form_factor(cylinder, 1, 0).value(), 0.8284271247461901);
    EXPECT_FALSE(known_form_factor(cylinder, 1, 2));

    const Scene cubes = built_in_scene("nested_cubes");
    EXPECT_DOUBLE_EQ(known_form_factor(cubes, 0, 1).value(), 0.19029155764741687);
    EXPECT_DOUBLE_EQ(known_form_factor(cubes, 2, 0).value(), 0.12772265829922139);
    EXPECT_FALSE(known_form_factor(cubes, 0, 6));
    EXPECT_FALSE(known_form_factor(built_in_scene("cube"), 0, 1));
}

TEST(ExactFormFactors, AreNotTakenFromFormulasThatIgnoreOccluders) {
    EXPECT_FALSE(exact_form_factors(built_in_scene("squares_blocked")));
    EXPECT_FALSE(exact_form_factors(built_in_scene("nested_cubes")));
    EXPECT_TRUE(exact_form_factors(built_in_scene("parallel_squares_far")));
}

}  // namespace
}  // namespace ff
