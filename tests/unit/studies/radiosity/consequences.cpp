#include "studies/radiosity/consequences.hpp"

#include "core/exact/exact.hpp"
#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"
#include "studies/radiosity/cost.hpp"
#include "studies/results/results.hpp"
#include "tests/support/studies.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

namespace ff::studies::radiosity {
namespace {

constexpr std::string_view reciprocal_rays = R"([[method]]
name = "SR"
sampler = "random"
estimator = "ray_shooting"
completion = "reciprocal"
samples_per_patch = 200
)";

constexpr std::string_view pdm_and_exact = R"([[method]]
name = "PDM"
sampler = "gauss_legendre"
nodes = 5
estimator = "area_kernel"
[[method]]
name = "exact"
estimator = "closed_form"
)";

StudyPlan lit_plan(std::string_view trials, std::string_view methods, std::string_view light = "") {
    return test::plan_of(test::study_text(trials, std::string(methods) + "[radiosity]\n" + std::string(light)));
}

const Results& small_results() {
    static const Results made = find_consequences(
        test::run(lit_plan("trials = 100", std::string(reciprocal_rays) + std::string(pdm_and_exact))));
    return made;
}

const Consequences& of(std::size_t cell, Treatment treatment) {
    return *small_results().find(cell, treatment);
}

TEST(Consequences, KeepDominanceForDirectRaysAtEveryReflectance) {
    const Consequences& direct = of(0, Treatment::direct);
    EXPECT_NEAR(direct.dominant_below.least, 1, 1e-14);
    for (const SettingStatistics& at : direct.settings) {
        EXPECT_EQ(at.dominant, 100u);
        EXPECT_EQ(at.convergent, 100u);
        EXPECT_NEAR(at.energy_defect->median, 0, 0.05);
    }
    EXPECT_GT(direct.reciprocity_defect.least, 0);
}

TEST(Consequences, MayLoseDominanceForReciprocalRays) {
    const Consequences& reciprocal = of(0, Treatment::reciprocal);
    EXPECT_LT(reciprocal.dominant_below.median, 0.999);
    EXPECT_LT(reciprocal.settings.back().dominant, 100u);
    EXPECT_LT(reciprocal.settings.back().convergent, 100u);
    EXPECT_GT(reciprocal.settings.back().negative, 0u);
    EXPECT_EQ(reciprocal.settings.front().dominant, 100u);
    EXPECT_TRUE(reciprocal.settings.front().light_error);
    EXPECT_FALSE(reciprocal.settings.back().light_error) << "trials lie on either side of a pole";
    EXPECT_FALSE(reciprocal.settings.back().exitance[0].mean);
    EXPECT_LT(reciprocal.reciprocity_defect.largest, 1e-15);
}

// Its rows sum to more than 1: found here from the estimates themselves.
TEST(Consequences, LoseDominanceForPdmAboveTheReciprocalOfARowSum) {
    const Consequences& found = of(1, Treatment::direct);
    ASSERT_EQ(found.trials, 1u);
    const double limit = found.dominant_below.median;
    EXPECT_LT(limit, 0.99);
    EXPECT_NEAR(1 / limit - 1, found.closure_defect.median, 1e-12);
    for (const SettingStatistics& at : found.settings) {
        const double reflectance = RadiosityRequest().reflectance[at.setting].front();
        EXPECT_EQ(at.dominant == 1, reflectance < limit) << reflectance;
        EXPECT_EQ(at.divergent == 1, reflectance > limit) << reflectance;
        EXPECT_EQ(at.negative == 1, reflectance > limit) << "no light solves it";
    }
    // Sweeps diverge where the spectral radius is above 1, and say so.
    EXPECT_EQ(found.settings.back().solvers.front().diverged, 1u);
    EXPECT_EQ(found.settings.front().solvers.front().converged, 1u);
}

TEST(Consequences, VanishForExactFactors) {
    for (const Treatment treatment : all_treatments) {
        const Consequences& found = of(2, treatment);
        EXPECT_LT(found.factor_error.median, 1e-14);
        for (const SettingStatistics& at : found.settings) {
            EXPECT_EQ(at.dominant, 1u);
            for (const ExitanceStatistics& e : at.exitance) EXPECT_NEAR(*e.mean / e.exact, 1, 1e-11) << name(treatment);
        }
    }
}

TEST(Treatments, RemoveTheDefectsThatTheyPromiseToRemove) {
    EXPECT_LT(of(0, Treatment::normalised).closure_defect.largest, 1e-14);
    EXPECT_GT(of(0, Treatment::normalised).reciprocity_defect.median, 1e-4);
    const Consequences& balanced = of(0, Treatment::balanced);
    EXPECT_EQ(balanced.not_balanced, 0u);
    EXPECT_LT(balanced.closure_defect.largest, 1e-11);
    EXPECT_LT(balanced.reciprocity_defect.largest, 1e-12);
    EXPECT_GT(balanced.correction.least, 0);
    EXPECT_EQ(of(0, Treatment::direct).correction.largest, 0);
    EXPECT_LT(balanced.factor_error.median, of(0, Treatment::direct).factor_error.median);
    // Errors of adjacent pairs are spread over all: parallel ones, which were exact, pay for closure.
    EXPECT_LT(of(1, Treatment::balanced).factor_error.median, of(1, Treatment::direct).factor_error.median);
}

const Results& between_patches() {
    static const Results made = find_consequences(test::run(lit_plan("trials = 8", R"([[method]]
name = "SR"
sampler = "random"
estimator = "ray_shooting"
completion = "reciprocal"
patches_per_face = [1, 4]
samples_per_patch = 400
[[method]]
name = "PDM"
sampler = "gauss_legendre"
nodes = 5
estimator = "area_kernel"
patches_per_face = [4, 16]
[[method]]
name = "points"
sampler = "random"
estimator = "point_to_polygon"
patches_per_face = 4
samples_per_patch = 16
)",
                                                                     "patch_trials = 5\n")));
    return made;
}

TEST(PatchConsequences, CoverDividedFacesAndTheRequestedTrials) {
    const Results& results = between_patches();
    for (const auto& [cell, patches, trials] :
         {std::tuple{std::size_t{1}, 24u, 5u}, {std::size_t{2}, 24u, 1u}, {std::size_t{3}, 96u, 1u}}) {
        const Consequences* found = results.find(cell, Treatment::direct, Between::patches);
        ASSERT_NE(found, nullptr);
        EXPECT_EQ(found->trials, trials);
        EXPECT_EQ(found->settings[0].exitance.size(), patches + 1);
        EXPECT_EQ(results.exact_system(0, 0, patches == 24 ? 2 : 4).exitance.size(), patches);
    }
    EXPECT_EQ(results.find(0, Treatment::direct, Between::patches), nullptr) << "one patch per face: the face itself";
    EXPECT_EQ(results.find(4, Treatment::direct, Between::patches), nullptr) << "points tell faces apart, not patches";
    EXPECT_NE(results.find(4, Treatment::direct), nullptr);
    EXPECT_EQ(small_results().find(0, Treatment::direct, Between::patches), nullptr) << "nobody asked";
}

// The light that a patch gathers varies over a face: patches change the light of a face by some percent, and ever less
// as they shrink.
TEST(PatchConsequences, HaveExactSolutionsThatConverge) {
    for (std::size_t setting = 0; setting < 5; ++setting) {
        const Eigen::VectorXd& faces = between_patches().exact_system(0, setting).exitance;
        const Eigen::VectorXd& coarse = between_patches().exact_system(0, setting, 2).exitance;
        const Eigen::VectorXd& fine = between_patches().exact_system(0, setting, 4).exitance;
        EXPECT_NEAR(fine.mean() / faces.mean(), 1, 1e-10) << "one reflectance: what is emitted is absorbed";
        const double from_faces = std::abs(coarse.head(4).mean() - faces[0]);
        EXPECT_LT(std::abs(fine.head(16).mean() - coarse.head(4).mean()), from_faces);
        EXPECT_GT(from_faces / faces[0], 1e-5) << "nearly even at 0.999";
    }
}

TEST(PatchConsequences, RemoveTheDefectsThatTheyPromiseToRemove) {
    const auto of = [](Treatment treatment) -> const Consequences& {
        return *between_patches().find(1, treatment, Between::patches);
    };
    EXPECT_LT(of(Treatment::direct).closure_defect.largest, 1e-13);
    EXPECT_GT(of(Treatment::direct).reciprocity_defect.least, 1e-3);
    EXPECT_GT(of(Treatment::reciprocal).closure_defect.least, 1e-3);
    EXPECT_LT(of(Treatment::reciprocal).reciprocity_defect.largest, 1e-15);
    EXPECT_EQ(of(Treatment::balanced).not_balanced, 0u);
    EXPECT_LT(of(Treatment::balanced).closure_defect.largest, 1e-12);
    EXPECT_LT(of(Treatment::balanced).reciprocity_defect.largest, 1e-13);
    EXPECT_LT(of(Treatment::balanced).factor_error.largest, of(Treatment::direct).factor_error.least);
    EXPECT_FALSE(of(Treatment::reciprocal).settings[0].solvers.empty());
    EXPECT_EQ(of(Treatment::reciprocal).settings[0].solvers[0].runs, 1u);
    EXPECT_TRUE(of(Treatment::direct).settings[0].solvers.empty());
}

// The row of a corner patch has the same error however small the patches are: dividing helps faces, not the worst
// patch.
TEST(PatchConsequences, LoseDominanceForPdmAtOneReflectanceForAnySubdivision) {
    const double coarse = between_patches().find(2, Treatment::direct, Between::patches)->dominant_below.median;
    const double fine = between_patches().find(3, Treatment::direct, Between::patches)->dominant_below.median;
    EXPECT_LT(coarse, 0.9);
    EXPECT_NEAR(fine / coarse, 1, 1e-3);
    const auto faces = [](std::size_t cell) { return between_patches().find(cell, Treatment::direct)->dominant_below; };
    EXPECT_GT(faces(3).median, faces(2).median + 0.02);
}

TEST(PatchTrials, RefuseTooManyPatchesForAMatrixOfPairs) {
    const auto message = [](std::string_view estimator, int patches) {
        return test::message_of<UserError>([&] {
            lit_plan("trials = 4",
                     fmt::format("[[method]]\nname = \"m\"\nsampler = \"random\"\nestimator = \"{}\"\n"
                                 "patches_per_face = {}\nsamples_per_patch = 1\n",
                                 estimator, patches),
                     "patch_trials = 1\n");
        });
    };
    EXPECT_EQ(message("ray_shooting", 1600), "nothing thrown");
    EXPECT_THAT(message("ray_shooting", 1681), testing::HasSubstr("at most 10000 patches with ray_shooting"));
    EXPECT_EQ(message("area_kernel", 484), "nothing thrown");
    EXPECT_THAT(message("area_kernel", 529), testing::HasSubstr("at most 3000 patches with area_kernel"));
    EXPECT_EQ(message("point_to_polygon", 1681), "nothing thrown") << "it has no systems between patches";
}

TEST(RadiosityCost, GrowsWithTheSquareOfThePatches) {
    const auto plan = [](int patches, int trials) {
        return lit_plan("trials = 4",
                        fmt::format("[[method]]\nname = \"m\"\nsampler = \"random\"\nestimator = \"ray_shooting\"\n"
                                    "patches_per_face = {}\nsamples_per_patch = 1\n",
                                    patches),
                        fmt::format("patch_trials = {}\n", trials));
    };
    const std::uint64_t of_400 = memory_needed(plan(400, 1));
    EXPECT_GT(of_400, 2400ULL * 2400 * 8 * 4) << "exact factors, estimates, system, elimination";
    EXPECT_NEAR(static_cast<double>(memory_needed(plan(1600, 1))) / static_cast<double>(of_400), 16, 0.1);
    EXPECT_LT(memory_needed(plan(400, 0)), 100'000u);
    EXPECT_GT(seconds_needed(plan(1600, 1)), 16 * seconds_needed(plan(400, 1))) << "elimination: n^3";
    EXPECT_LT(seconds_needed(plan(1600, 0)), 0.01);
    EXPECT_EQ(memory_needed(test::plan_of(test::study_text("trials = 4", reciprocal_rays))), 0u);
}

// Uniform light in a uniform box hides all errors of rows that sum to 1: e / (1 - rho) in every trial.
TEST(Consequences, VanishForAFurnace) {
    const auto results = find_consequences(
        test::run(lit_plan("trials = 20", reciprocal_rays, "reflectance = [0.5, 0.99]\nemission = 2\n")));
    for (const SettingStatistics& at : results.find(0, Treatment::direct)->settings) {
        const double expected = 2 / (1 - (at.setting == 0 ? 0.5 : 0.99));
        for (const ExitanceStatistics& e : at.exitance) {
            EXPECT_NEAR(e.exact / expected, 1, 1e-12);
            EXPECT_NEAR(e.q025 / expected, 1, 1e-12);
            EXPECT_NEAR(e.q975 / expected, 1, 1e-12);
        }
    }
    EXPECT_GT(results.find(0, Treatment::reciprocal)->settings[0].exitance[1].std.value(), 1e-3);
}

TEST(SolverRuns, AreKeptForTheFirstTrialsOfTheMethodsOwnCompletion) {
    EXPECT_TRUE(of(0, Treatment::direct).settings[0].solvers.empty());
    const auto& solvers = of(0, Treatment::reciprocal).settings[0].solvers;
    ASSERT_EQ(solvers.size(), all_solvers.size());
    for (const SolverStatistics& found : solvers) {
        EXPECT_EQ(found.runs, RadiosityRequest().solver_trials);
        EXPECT_EQ(found.runs, found.converged + found.diverged + found.stalled + found.exhausted);
        EXPECT_FALSE(found.residuals.empty());
    }
    EXPECT_EQ(small_results().exact.size(), RadiosityRequest().reflectance.size());
}

// With direct rows of independent rays the factors are unbiased. Two errors meet in the second reflection, so that the
// exitance has a bias, and half the rays make it twice as large: -1 within 6 standard errors of the slope.
TEST(BiasOrder, IsOneOverNForUnbiasedFactors) {
    const StudyPlan plan = lit_plan("trials = 15000", R"([[method]]
name = "SR"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = [100, 200, 400]
)",
                                    "reflectance = 0.8\n");
    const auto results = find_consequences(test::run(plan));
    const auto orders = bias_orders(plan, results);
    // Where rows and columns both sum to 1 the mean exitance of a cube is what it is: nothing varies when balanced.
    ASSERT_EQ(orders.size(), 3u);
    const BiasOrder& reciprocal = orders[1];
    ASSERT_EQ(reciprocal.treatment, Treatment::reciprocal);
    ASSERT_EQ(reciprocal.points.size(), 3u);
    for (const auto& point : reciprocal.points) EXPECT_GT(point.bias, 6 * point.error);
    ASSERT_TRUE(reciprocal.slope);
    // Second order in 1/N: at N = 100 the next term is some tenth, and the slope off by as much.
    EXPECT_NEAR(*reciprocal.slope, -1, 0.25);
    EXPECT_LT(reciprocal.interval->width(), 0.3) << "or the slope would say nothing";
}

TEST(RadiosityRequest, RefusesUnphysicalValues) {
    const auto message = [](std::string_view light) {
        return test::message_of<UserError>([&] { lit_plan("trials = 4", reciprocal_rays, light); });
    };
    using testing::HasSubstr;
    EXPECT_THAT(message("reflectance = [0.5, 1]"), HasSubstr("1 is 1 or more: light that nothing absorbs piles up"));
    EXPECT_THAT(message("reflectance = 0.9999999999999999"), HasSubstr("rounding decides"));
    EXPECT_THAT(message("reflectance = -0.5"), HasSubstr("below 0"));
    EXPECT_THAT(message("reflectance = [[0.5, 0.5]]"), HasSubstr("has 2 numbers (scene 'cube' has 6 faces)"));
    EXPECT_THAT(message("reflectance = []"), HasSubstr("leaves nothing to do"));
    EXPECT_THAT(message("reflectance = [\"bright\"]"), HasSubstr("Write it like"));
    EXPECT_THAT(message("emission = [0, 0, 0, 0, 0, -1]"), HasSubstr("no surface emits that"));
    EXPECT_THAT(message("emission = 1e31"), HasSubstr("Use another unit"));
    EXPECT_THAT(message("emission = [0, 0, 0, 0, 1, 5e-324]"), HasSubstr("Use another unit"));
    EXPECT_THAT(message("reflectance = [1e-200]"), HasSubstr("Give 0, or 1e-30 at least"));
    EXPECT_THAT(message("emission = 0"), HasSubstr("all would be dark"));
    EXPECT_THAT(message("emission = [1, 0]"), HasSubstr("emission has 2 numbers"));
    EXPECT_THAT(message("tolerance = 1"), HasSubstr("Try 1e-6"));
    EXPECT_THAT(message("reflectence = 0.5"), HasSubstr("reflectance"));
    EXPECT_EQ(message("reflectance = [0.5, [0.1, 0.2, 0.3, 0.4, 0.5, 0]]"), "nothing thrown");
}

TEST(RadiosityRequest, NeedsAClosedScene) {
    Scene scene = lit_plan("trials = 4", reciprocal_rays).scenes.front();
    EXPECT_NO_THROW(expect_fitting(RadiosityRequest(), scene));
    scene.closed = false;
    EXPECT_THROW(expect_fitting(RadiosityRequest(), scene), UserError);
}

}  // namespace
}  // namespace ff::studies::radiosity
