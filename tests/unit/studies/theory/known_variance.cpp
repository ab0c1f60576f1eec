#include "studies/theory/known_variance.hpp"

#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>

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

TEST(KnownVariance, IsNoBetterWithTheGradedMapWhereOcclusionIsPossible) {
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

TEST(KnownVariance, IsFiniteForOtherEstimatorsAndAbsentWithoutRandomness) {
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

/// A unit square, and a small one above its middle that looks down on it.
Scene lamp_above_square(double edge, double height) {
    const double low = (1 - edge) / 2;
    Scene scene = two_squares(0);
    scene.surfaces[1] = {Parallelogram{{low, low, height}, {edge, 0, 0}, {0, edge, 0}}, {0, 0, -1}, 1};
    return scene;
}

stats::KnownLimits limits_of(const Method& method, const Scene& scene, Quantity quantity, std::uint64_t evaluations) {
    return known_limits(method, scene, {}, quantity, evaluations, 10);
}

TEST(KnownLimits, AllowForAPeakThatFewEvaluationsMeet) {
    const Method method = kernel(PointMap::uniform);
    const Scene scene = lamp_above_square(0.01, 0.01);
    const Quantity pair{QuantityKind::form_factor, 1, 2};
    const stats::KnownLimits few = limits_of(method, scene, pair, 100);
    // 1 / (pi 0.01²), times the area of the lamp.
    EXPECT_NEAR(few.unmet.largest, 1e-4 / (std::numbers::pi * 1e-4), 1e-12);
    EXPECT_EQ(few.unmet.evaluations, 1000);
    EXPECT_EQ(limits_of(method, scene, pair, 1'000'000).unmet.largest, 0) << "2000 of 10 million lie beneath the lamp";
    EXPECT_EQ(limits_of(method, lamp_above_square(0.5, 1), pair, 100).unmet.largest, 0) << "no peak";
}

TEST(KnownLimits, FollowFromTheReverseFactorUnderReciprocity) {
    Method method = kernel(PointMap::uniform);
    const Scene scene = lamp_above_square(0.01, 0.01);
    method.completion = Completion::reciprocal;
    const double forth = limits_of(method, scene, {QuantityKind::form_factor, 1, 2}, 100).unmet.largest;
    const double back = limits_of(method, scene, {QuantityKind::form_factor, 2, 1}, 100).unmet.largest;
    EXPECT_NEAR(back, 1e4 * forth, 1e-9 * back);
}

TEST(KnownLimits, AddUpInARowSum) {
    const Method method = kernel(PointMap::uniform);
    const Scene scene = lamp_above_square(0.01, 0.01);
    const double term = limits_of(method, scene, {QuantityKind::form_factor, 1, 2}, 100).unmet.largest;
    const stats::KnownLimits sum = limits_of(method, scene, {QuantityKind::row_sum, 1, 0}, 100);
    EXPECT_GE(sum.unmet.largest, term);
    EXPECT_EQ(sum.unmet.evaluations, 1000);
}

TEST(KnownLimits, CountPointsAndTheirMirrorImagesOnce) {
    Method method = kernel(PointMap::uniform);
    method.sampler = "antithetic";
    EXPECT_EQ(
        limits_of(method, lamp_above_square(0.01, 0.01), {QuantityKind::form_factor, 1, 2}, 100).unmet.evaluations,
        500);
}

TEST(RoundingOfBias, GrowsWithTheExtentRelativeToTheSourceArea) {
    const Quantity pair{QuantityKind::form_factor, 1, 2};
    const double near = rounding_of_bias(lamp_above_square(0.5, 1), pair);
    EXPECT_NEAR(near, 1e-15, 1e-17);
    EXPECT_NEAR(rounding_of_bias(lamp_above_square(0.5, 1000), pair), 1e-15 + 1e-12, 1e-17);
    EXPECT_DOUBLE_EQ(rounding_of_bias(make_box(1, 1, 1), {QuantityKind::row_sum, 1, 0}), 6e-15);
}

}  // namespace
}  // namespace ff::studies
