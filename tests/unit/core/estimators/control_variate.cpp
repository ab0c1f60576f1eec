#include "core/estimators/pairs/control_variate.hpp"

#include "core/estimators/pairs/area_kernel.hpp"
#include "core/exact/exact.hpp"
#include "core/geometry/box.hpp"
#include "tests/support/estimator_trials.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace ff {
namespace {

double mean_square_error(const std::vector<double>& values, double exact) {
    double sum = 0;
    for (const double value : values) sum += (value - exact) * (value - exact);
    return sum / static_cast<double>(values.size());
}

TEST(ControlVariate, IsExactWithoutOccluders) {
    const Scene box = make_box(3, 2, 1);
    const Eigen::MatrixXd exact = *exact_form_factors(box);
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j)
            EXPECT_NEAR(test::estimates<ControlVariate>(box, 1, 1, 1, i, j).front(), exact(i, j), 1e-14);
    }
}

// A small wall between two squares hides little, so that hardly any of the kernel's variance is left. 400 trials of 64
// points.
TEST(ControlVariate, HasOnlyTheErrorOfTheHiddenPart) {
    Scene scene;
    scene.faces = {"a", "b"};
    scene.surfaces = {{Parallelogram{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 0, 1}, 0},
                      {Parallelogram{{0, 0, 0.5}, {1, 0, 0}, {0, 1, 0}}, {0, 0, -1}, 1}};
    const double whole = test::estimates<ControlVariate>(scene, 1, 1, 1, 0, 1).front();
    scene.surfaces.push_back({Parallelogram{{0.45, 0.45, 0.25}, {0.1, 0, 0}, {0, 0.1, 0}}, {0, 0, 1}, no_face});
    const auto controlled = test::estimates<ControlVariate>(scene, 1, 64, 400, 0, 1);
    const auto kernel = test::estimates<AreaKernel>(scene, 1, 64, 400, 0, 1);
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
