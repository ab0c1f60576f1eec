#include "studies/results/results.hpp"

#include "core/exact/exact.hpp"
#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"
#include "studies/radiosity/cost.hpp"
#include "tests/support/studies.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <atomic>
#include <cmath>
#include <string>

namespace ff::studies::radiosity {
namespace {

StudyPlan lit_ray_plan(std::string_view light, std::string_view patches = "1") {
    return test::plan_of(test::study_text("trials = 4",
                                          "[[method]]\nname = \"SR\"\nsampler = \"random\"\n"
                                          "estimator = \"ray_shooting\"\nsamples_per_patch = 16\n"
                                          "patches_per_face = " +
                                              std::string(patches) + "\n[radiosity]\n" + std::string(light)));
}

// Errors of different direct rows are independent, so that in the second order only those within a row meet:
// b_i = rho^2 / N times the covariance of M_ji and m_j over where a ray from i falls, and M b is the bias, with
// M = (I - rho F)^-1. In a flat box it can be seen: here it is 7 standard errors, and expected within 5 of them.
TEST(Bias, ComesFromErrorsWithinARowForDirectRows) {
    const double rho = 0.9;
    const double rays_of_a_face = 4;
    const double trials = 30000;
    const auto results = find_consequences(test::run(test::plan_of(R"([study]
name = "flat"
scene = "box:4x4x0.5"
trials = 30000
seed = 3
[[method]]
name = "SR"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = 4
[radiosity]
reflectance = 0.9
emission = [1, 0, 0, 0, 0, 0]
solver_trials = 0
)")));
    const Scene scene = make_box(4, 4, 0.5);
    const Eigen::MatrixXd factors = exact_form_factors(scene).value();
    const Eigen::MatrixXd inverse = (Eigen::MatrixXd::Identity(6, 6) - rho * factors).inverse();
    const Eigen::VectorXd exitance = inverse.col(0);
    Eigen::VectorXd own(6);
    Eigen::VectorXd areas(6);
    for (Eigen::Index i = 0; i < 6; ++i) {
        const Eigen::VectorXd p = factors.row(i).transpose();
        const Eigen::VectorXd back = inverse.col(i);
        own[i] = rho * rho / rays_of_a_face * (p.dot(back.cwiseProduct(exitance)) - p.dot(back) * p.dot(exitance));
        areas[i] = face_area(scene, static_cast<int>(i));
    }
    const double expected = areas.dot(inverse * own) / areas.sum();
    const ExitanceStatistics& all = results.find(0, Treatment::direct)->settings[0].exitance[0];
    const double error = *all.std / std::sqrt(trials);
    EXPECT_GT(expected, 6 * error) << "or the test would not see it";
    EXPECT_NEAR(*all.bias, expected, 5 * error);
}

TEST(Evaluation, CanBeStoppedOnlyInThePartBetweenPatches) {
    const StudyPlan plan = lit_ray_plan("patch_trials = 3\n", "4");
    const Store store = test::run(plan);
    const std::atomic<bool> at_once = true;
    const auto stopped = find_consequences(store, &at_once);
    EXPECT_NE(stopped.find(0, Treatment::direct), nullptr);
    EXPECT_EQ(stopped.find(0, Treatment::direct, Between::patches), nullptr);
    EXPECT_EQ(patch_trials(plan, stopped).done, 0u);
    EXPECT_EQ(patch_trials(plan, stopped).wanted, 3u);
    EXPECT_FALSE(patch_trials(plan, stopped).complete());
    const std::atomic<bool> never = false;
    EXPECT_TRUE(patch_trials(plan, find_consequences(store, &never)).complete());
}

TEST(SolverRuns, AreLimitedByTheirCostBetweenPatches) {
    const StudyPlan plan = lit_ray_plan("reflectance = [0.5, 0.999]\n");
    EXPECT_TRUE(runs_solvers(plan, 1014, 0));
    EXPECT_FALSE(runs_solvers(plan, 1014, 1));
    EXPECT_TRUE(runs_solvers(plan, 256, 1));
    EXPECT_FALSE(runs_solvers(lit_ray_plan("solver_trials = 0\n"), 54, 0));
}

TEST(StudyResults, HaveRadiosityOnlyWhereItIsAskedFor) {
    EXPECT_FALSE(evaluate(test::run(test::plan_of(test::study_text("trials = 4", test::random_rays)))).radiosity);
    EXPECT_TRUE(evaluate(test::run(lit_ray_plan(""))).radiosity);
}

}  // namespace
}  // namespace ff::studies::radiosity
