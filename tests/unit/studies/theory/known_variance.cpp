#include "studies/theory/known_variance.hpp"

#include "core/geometry/box.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ff::studies {
namespace {

Method kernel(PointMap map) {
    Method method;
    method.sampler = "random";
    method.estimator = "area_kernel";
    method.map = map;
    return method;
}

VarianceStatus of_pair(const Method& method, const Scene& scene, int from, int to) {
    return known_variance(method, scene, {QuantityKind::form_factor, from, to});
}

/// Unit squares at a right angle, the second one shifted along the line where their planes meet.
Scene two_squares(double shift) {
    Scene scene;
    scene.surfaces = {{Parallelogram{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 0, 1}, 0},
                      {Parallelogram{{shift, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {0, 1, 0}, 1}};
    scene.faces = {"1", "2"};
    return scene;
}

TEST(KnownVariance, IsInfiniteWherePatchesTouch) {
    const Method method = kernel(PointMap::uniform);
    EXPECT_EQ(of_pair(method, two_squares(0), 1, 2), VarianceStatus::infinite) << "a common edge";
    EXPECT_EQ(of_pair(method, two_squares(0.3), 1, 2), VarianceStatus::infinite) << "part of one";
    EXPECT_EQ(of_pair(method, two_squares(1), 1, 2), VarianceStatus::infinite) << "a common vertex";
    EXPECT_EQ(of_pair(method, two_squares(1.01), 1, 2), VarianceStatus::finite) << "a gap";
}

TEST(KnownVariance, IsFiniteWithTheGradedMap) {
    const Method method = kernel(PointMap::graded);
    EXPECT_EQ(of_pair(method, two_squares(0), 1, 2), VarianceStatus::finite);
    EXPECT_EQ(of_pair(method, two_squares(1), 1, 2), VarianceStatus::finite);
}

TEST(KnownVariance, IsNoBetterWithTheGradedMapWhereSomethingMayStandInBetween) {
    // The corner square lies in the way of some rays, not of those near the common edge.
    Scene scene = two_squares(0);
    scene.surfaces.push_back({Parallelogram{{0.4, 0.4, 0.4}, {0.2, 0, 0}, {0, 0.1, -0.1}},
                              Eigen::Vector3d(0, 1, 1) / std::sqrt(2.0), no_face});
    EXPECT_EQ(of_pair(kernel(PointMap::graded), scene, 1, 2), VarianceStatus::infinite);
}

TEST(KnownVariance, IsNoBetterWithTheGradedMapForTriangles) {
    Scene scene = two_squares(0);
    scene.surfaces[1].shape = Triangle{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    EXPECT_EQ(of_pair(kernel(PointMap::graded), scene, 1, 2), VarianceStatus::infinite);
}

TEST(KnownVariance, IsInfiniteForASumWithAnInfiniteTerm) {
    const Scene box = make_box(3, 2, 1);
    const Quantity row{QuantityKind::row_sum, 1, 0};
    const Quantity all{QuantityKind::sum_relative_error, 0, 0};
    EXPECT_EQ(of_pair(kernel(PointMap::uniform), box, 1, 6), VarianceStatus::finite);
    EXPECT_EQ(known_variance(kernel(PointMap::uniform), box, row), VarianceStatus::infinite);
    EXPECT_EQ(known_variance(kernel(PointMap::uniform), box, all), VarianceStatus::infinite);
    EXPECT_EQ(known_variance(kernel(PointMap::graded), box, all), VarianceStatus::finite);
}

TEST(KnownVariance, IsFiniteForOtherEstimatorsAndNoneWithoutRandomness) {
    Method method = kernel(PointMap::uniform);
    for (const std::string_view estimator : {"ray_shooting", "point_to_polygon"}) {
        method.estimator = estimator;
        EXPECT_EQ(of_pair(method, two_squares(0), 1, 2), VarianceStatus::finite);
    }
    method.estimator = "area_kernel";
    method.sampler = "gauss_legendre";
    EXPECT_EQ(of_pair(method, two_squares(0), 1, 2), VarianceStatus::none);
    method.sampler = "";
    method.estimator = "closed_form";
    EXPECT_EQ(of_pair(method, two_squares(0), 1, 2), VarianceStatus::none);
}

}  // namespace
}  // namespace ff::studies
