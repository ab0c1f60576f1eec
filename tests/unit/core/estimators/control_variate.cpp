#include "core/estimators/control_variate.hpp"

#include "core/estimators/area_kernel.hpp"
#include "core/exact/exact.hpp"
#include "core/geometry/box.hpp"
#include "tests/support/philox_points.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace ff {
namespace {

template <class T>
std::vector<double> estimates(const Scene& scene, std::uint64_t samples, std::uint32_t trials, int from, int to) {
    const test::PhiloxPoints points(samples);
    const T estimator(scene, TracerChoice::automatic);
    std::vector<double> result;
    for (std::uint32_t trial = 0; trial < trials; ++trial) {
        Outcome outcome;
        PatchTotals totals;
        estimator.observe(
            {.subdivision = {1}, .points = &points, .samples = samples, .options = {}, .key = {1, 2}, .trial = trial},
            outcome, totals);
        result.push_back(outcome.estimates(from, to));
    }
    return result;
}

double mean_square_error(const std::vector<double>& values, double exact) {
    double sum = 0;
    for (const double value : values) sum += (value - exact) * (value - exact);
    return sum / static_cast<double>(values.size());
}

TEST(ControlVariate, IsExactWhereNothingStandsInBetween) {
    const Scene box = make_box(3, 2, 1);
    const Eigen::MatrixXd exact = *exact_form_factors(box);
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) EXPECT_NEAR(estimates<ControlVariate>(box, 1, 1, i, j).front(), exact(i, j), 1e-14);
    }
}

// A wall of small extent between two squares hides little: of the kernel's variance hardly anything is left. 400 trials
// of 64 points.
TEST(ControlVariate, LeavesOnlyTheErrorOfWhatIsHidden) {
    Scene scene;
    scene.faces = {"a", "b"};
    scene.surfaces = {{Parallelogram{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 0, 1}, 0},
                      {Parallelogram{{0, 0, 0.5}, {1, 0, 0}, {0, 1, 0}}, {0, 0, -1}, 1}};
    const double whole = estimates<ControlVariate>(scene, 1, 1, 0, 1).front();
    scene.surfaces.push_back({Parallelogram{{0.45, 0.45, 0.25}, {0.1, 0, 0}, {0, 0.1, 0}}, {0, 0, 1}, no_face});
    const auto controlled = estimates<ControlVariate>(scene, 64, 400, 0, 1);
    const auto kernel = estimates<AreaKernel>(scene, 64, 400, 0, 1);
    double mean = 0;
    for (const double value : controlled) mean += value / 400;
    EXPECT_LT(mean, whole);
    EXPECT_LT(mean_square_error(controlled, mean), 0.5 * mean_square_error(kernel, mean));
}

TEST(ControlVariate, HasNoVarianceWhereFacesTouchPastAnOccluder) {
    Scene room = make_box(6, 6, 6);
    EXPECT_TRUE(ControlVariate::finite_variance({}, room, 0, 1));
    room.empty_box.reset();
    room.surfaces.push_back({Parallelogram{{2, 2, 3}, {2, 0, 0}, {0, 2, 0}}, {0, 0, 1}, no_face});
    EXPECT_FALSE(ControlVariate::finite_variance({}, room, 0, 1));
    EXPECT_TRUE(ControlVariate::finite_variance({}, room, 0, 5));
}

}  // namespace
}  // namespace ff
