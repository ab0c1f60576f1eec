#include "core/estimators/points/point_to_polygon.hpp"

#include "core/configurations/catalogue.hpp"
#include "core/estimators/pairs/area_kernel.hpp"
#include "core/geometry/box.hpp"
#include "tests/support/philox_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ff {
namespace {

Eigen::MatrixXd trial(const auto& estimator, std::uint64_t samples, std::uint32_t number,
                      Allocation allocation = Allocation::patch) {
    const test::PhiloxPoints points(allocation == Allocation::face ? 9 * samples : samples);
    Outcome outcome;
    PatchTotals totals;
    estimator.observe({.subdivision = {3},
                       .points = &points,
                       .samples = samples,
                       .options = {.allocation = allocation},
                       .key = {1, 2},
                       .trial = number},
                      outcome, totals);
    return outcome.estimates;
}

// The same points and the same formula, from elsewhere in the code: only rounding differs.
TEST(PointToVisiblePolygon, EqualsPointToPolygonWithoutOccluders) {
    const Scene box = make_box(3, 2, 1);
    const PointToVisiblePolygon visible(box, TracerChoice::automatic);
    const PointToPolygon whole(box, TracerChoice::automatic);
    for (const Allocation allocation : {Allocation::patch, Allocation::face}) {
        const Eigen::MatrixXd difference = trial(visible, 100, 5, allocation) - trial(whole, 100, 5, allocation);
        EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-12);
    }
}

// Half of the square above is behind a screen that reaches to the middle plane's edge, as seen from its own height:
// a point on the floor below the screen's edge sees exactly the other half of a square that is symmetric to it.
TEST(PointToVisiblePolygon, SeesHalfOfAHalfScreenedPolygon) {
    Scene scene;
    scene.faces = {"spot", "square"};
    scene.surfaces = {{Parallelogram{{0.5 - 1e-9, 0.5 - 1e-9, 0}, {2e-9, 0, 0}, {0, 2e-9, 0}}, {0, 0, 1}, 0},
                      {Parallelogram{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}, {0, 0, -1}, 1}};
    const Eigen::MatrixXd whole = trial(PointToVisiblePolygon(scene, TracerChoice::automatic), 16, 0);
    scene.surfaces.push_back({Parallelogram{{-9, -9, 0.5}, {9.5, 0, 0}, {0, 18, 0}}, {0, 0, 1}, no_face});
    const Eigen::MatrixXd half = trial(PointToVisiblePolygon(scene, TracerChoice::automatic), 16, 0);
    EXPECT_NEAR(half(0, 1), 0.5 * whole(0, 1), 1e-8);
}

// Two of the kernel's four dimensions, those on the target, are integrated exactly. This leaves less than a tenth of
// the kernel's mean square error with as many evaluations. There are 200 trials of each, whose mean squares are known
// to 10 %.
TEST(PointToVisiblePolygon, LeavesOnlyTheErrorOfTheSource) {
    const Scene scene = *configuration_scene("squares_blocked");
    const PointToVisiblePolygon visible(scene, TracerChoice::automatic);
    const AreaKernel kernel(scene, TracerChoice::automatic);
    std::vector<double> of_visible, of_kernel;
    double mean = 0;
    for (std::uint32_t number = 0; number < 200; ++number) {
        of_visible.push_back(trial(visible, 9, number)(0, 1));
        of_kernel.push_back(trial(kernel, 1, number)(0, 1));
        mean += of_visible.back() / 200;
    }
    double ratio = 0;
    const auto squares = [&](const std::vector<double>& values) {
        double sum = 0;
        for (const double value : values) sum += std::pow(value - mean, 2);
        return sum;
    };
    ratio = squares(of_visible) / squares(of_kernel);
    EXPECT_LT(ratio, 0.1);
    EXPECT_GT(ratio, 0);
}

TEST(PointToVisiblePolygon, RefusesNonPolygonalOccluders) {
    EXPECT_NE(PointToVisiblePolygon::refusal({}, *configuration_scene("discs_blocked")), "");
    EXPECT_EQ(PointToVisiblePolygon::refusal({}, *configuration_scene("squares_through_aperture")), "");
}

}  // namespace
}  // namespace ff
