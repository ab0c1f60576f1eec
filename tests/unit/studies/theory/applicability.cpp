#include "studies/plan/plan.hpp"

#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ff::studies {
namespace {

using testing::HasSubstr;

Method method_of(std::string_view estimator, TracerChoice tracer = TracerChoice::automatic) {
    Method method;
    method.name = "a";
    method.estimator = estimator;
    method.tracer = tracer;
    return method;
}

std::string refusal(const Method& method, const Scene& scene) {
    try {
        expect_applicable(method, scene);
        return "";
    } catch (const UserError& error) {
        return error.what();
    }
}

/// A box in which a plate stands.
Scene occluded_scene() {
    Scene scene = make_box(6, 6, 6);
    scene.name = "room";
    scene.empty_box.reset();
    scene.surfaces.push_back({Parallelogram{{2, 2, 3}, {2, 0, 0}, {0, 2, 0}}, {0, 0, 1}, 6});
    scene.faces.emplace_back("plate");
    return scene;
}

TEST(Applicability, AllowsEveryEstimatorInABox) {
    for (const EstimatorEntry& estimator : estimators())
        EXPECT_EQ(refusal(method_of(estimator.info.name), make_box(2, 1, 0.5)), "");
}

TEST(Applicability, RefusesEstimatorsThatIgnoreOccluders) {
    for (const std::string_view estimator : {"closed_form", "point_to_polygon"}) {
        const std::string message = refusal(method_of(estimator), occluded_scene());
        EXPECT_THAT(message, HasSubstr("method 'a': " + std::string(estimator) + " cannot be used in scene 'room'"));
        EXPECT_THAT(message, HasSubstr("two of its faces may be occluded"));
    }
    EXPECT_EQ(refusal(method_of("area_kernel"), occluded_scene()), "");
    EXPECT_EQ(refusal(method_of("ray_shooting"), occluded_scene()), "");
}

TEST(Applicability, KeepsTheBoxTracerToEmptyBoxes) {
    EXPECT_THAT(refusal(method_of("ray_shooting", TracerChoice::box), occluded_scene()), HasSubstr("not an empty box"));
}

TEST(Applicability, KeepsRaysToBoxesThatSinglePrecisionResolves) {
    EXPECT_THAT(refusal(method_of("ray_shooting"), make_box(1, 1, 1e-5)), HasSubstr("cannot be traced"));
    EXPECT_EQ(refusal(method_of("point_to_polygon"), make_box(1, 1, 1e-5)), "");
}

}  // namespace
}  // namespace ff::studies
