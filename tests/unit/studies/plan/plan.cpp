#include "studies/plan/plan.hpp"

#include "core/exact/known_factors.hpp"
#include "core/geometry/placement.hpp"
#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"
#include "studies/scene_files/scene_file.hpp"
#include "tests/support/studies.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace ff::studies {
namespace {

using test::plan_in;
using test::plan_of;
using test::study_text;

constexpr std::string_view ladder_method = R"([[method]]
name = "SR"
sampler = "random"
estimator = "ray_shooting"
patches_per_face = [4, 9]
samples_per_patch = [100, 200]
)";

constexpr std::string_view pdm_method = R"([[method]]
name = "PDM"
sampler = "gauss_legendre"
estimator = "area_kernel"
nodes = [5, 6]
patches_per_face = 4
)";

std::string replaced(std::string text, std::string_view what, std::string_view with) {
    const auto at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), with);
}

std::vector<StreamKey> keys(const StudyPlan& plan) {
    std::vector<StreamKey> list;
    for (const Cell& cell : plan.cells) list.push_back(cell.key);
    return list;
}

StreamKey only_key(std::string_view scene, std::string_view method) {
    return plan_of(replaced(study_text("trials = 9", method), "cube", scene)).cells.at(0).key;
}

constexpr std::string_view rays_method = R"([[method]]
name = "SR"
sampler = "random"
estimator = "ray_shooting"
completion = "direct"
patches_per_face = 4
samples_per_patch = 100
)";

TEST(PlanKeys, DifferForEveryCell) {
    const auto list = keys(plan_of(study_text("trials = 9", std::string(ladder_method) + std::string(pdm_method))));
    ASSERT_EQ(list.size(), 5u);
    EXPECT_EQ(std::set<StreamKey>(list.begin(), list.end()).size(), list.size());
}

TEST(PlanKeys, DoNotDependOnOtherMethodsOrTheirOrder) {
    const auto alone = keys(plan_of(study_text("trials = 9", ladder_method)));
    const auto first = keys(plan_of(study_text("trials = 9", std::string(ladder_method) + std::string(pdm_method))));
    const auto last = keys(plan_of(study_text("trials = 9", std::string(pdm_method) + std::string(ladder_method))));
    EXPECT_TRUE(std::equal(alone.begin(), alone.end(), first.begin()));
    EXPECT_TRUE(std::equal(alone.begin(), alone.end(), last.begin() + 1));
}

TEST(PlanKeys, DoNotDependOnNameCompletionTrialsOrOrderOfSizes) {
    const std::string text(rays_method);
    const StreamKey key = only_key("cube", text);
    EXPECT_EQ(only_key("cube", replaced(text, "SR", "other name")), key);
    EXPECT_EQ(only_key("cube", replaced(text, "direct", "reciprocal")), key);
    EXPECT_EQ(only_key("cube", text + "trials = 77"), key);
    auto sizes = keys(plan_of(study_text("trials = 9", replaced(std::string(ladder_method), "[4, 9]", "[9, 4]"))));
    auto straight = keys(plan_of(study_text("trials = 9", ladder_method)));
    EXPECT_NE(sizes, straight);
    std::sort(sizes.begin(), sizes.end());
    std::sort(straight.begin(), straight.end());
    EXPECT_EQ(sizes, straight);
}

TEST(PlanKeys, DependOnEverythingThatAffectsTheNumbers) {
    const std::string text(rays_method);
    const StreamKey key = only_key("cube", text);
    EXPECT_NE(only_key("cube", replaced(text, "\"random\"", "\"random_mt\"")), key);
    EXPECT_NE(only_key("cube", replaced(text, "= 4", "= 9")), key);
    EXPECT_NE(only_key("cube", replaced(text, "= 100", "= 101")), key);
    EXPECT_NE(only_key("cube", replaced(text, "ray_shooting", "area_kernel")), key);
    EXPECT_NE(only_key("cube", text + "allocation = \"face\""), key);
    const std::string kernel = replaced(text, "ray_shooting", "area_kernel");
    EXPECT_NE(only_key("cube", kernel + "map = \"graded\""), only_key("cube", kernel));
    EXPECT_EQ(only_key("cube", kernel + "map = \"uniform\""), only_key("cube", kernel));
    EXPECT_NE(only_key("box:6x6x7", text), key);
    EXPECT_NE(plan_of(replaced(study_text("trials = 9", rays_method), "seed = 7", "seed = 8")).cells.at(0).key, key);
}

TEST(PlanKeys, DependOnTheSceneNotOnItsName) {
    EXPECT_EQ(only_key("cube", rays_method), only_key("box:6x6x6", rays_method));
    EXPECT_EQ(only_key("cube", rays_method), only_key("box:6.0x6x06", rays_method));
}

TEST(PlanUnits, CoverEveryTrialOnce) {
    const StudyPlan plan = plan_of(study_text("trials = 1000", R"([[method]]
name = "SR"
sampler = "random"
estimator = "ray_shooting"
sizes = [ { patches_per_face = 169, samples_per_patch = [1, 625, 10000] },
          { patches_per_face = 9, samples_per_patch = 1000000, trials = 33 } ]
)" + std::string(pdm_method)));
    std::map<std::size_t, std::uint64_t> next;  // trial, by cell
    for (std::size_t i = 0; i < plan.units.size(); ++i) {
        const WorkUnit& unit = plan.units[i];
        EXPECT_EQ(unit.index, i);
        EXPECT_EQ(unit.first_trial, next[unit.cell]);
        EXPECT_GE(unit.trials, 1u);
        next[unit.cell] += unit.trials;
    }
    ASSERT_EQ(next.size(), plan.cells.size());
    for (std::size_t cell = 0; cell < plan.cells.size(); ++cell) EXPECT_EQ(next[cell], plan.cells[cell].trials);
    EXPECT_EQ(plan.cells[3].trials, 33u);
}

TEST(PlanUnits, TakeAboutAFifthOfASecond) {
    const StudyPlan plan = plan_of(study_text("trials = 100000", ladder_method));
    for (const WorkUnit& unit : plan.units) {
        const double seconds =
            static_cast<double>(unit.trials) * expected_seconds_per_trial(plan, plan.cells[unit.cell]);
        EXPECT_LE(seconds, 0.2001);
    }
    EXPECT_GT(plan.units.size(), plan.cells.size());
}

TEST(Plan, RunsADeterministicMethodOnce) {
    const StudyPlan plan = plan_of(study_text("trials = 1000", pdm_method));
    EXPECT_TRUE(plan.cells.at(0).deterministic);
    EXPECT_EQ(plan.cells.at(0).trials, 1u);
    EXPECT_EQ(plan.cells.at(0).samples_per_patch, 900u);  // 5^2 times 6^2 points per pair
}

TEST(Plan, RunsEveryMethodOnEveryScene) {
    const StudyPlan plan =
        plan_of(replaced(study_text("trials = 9", ladder_method), "\"cube\"", R"(["cube", "box:1x2x3"])"));
    ASSERT_EQ(plan.scenes.size(), 2u);
    EXPECT_EQ(plan.cells.size(), 8u);
}

TEST(Plan, MovesScenesOfFilesToTheOrigin) {
    const auto scene_at = [](double x) {
        std::string text;
        for (const int face : {0, 1})
            text += fmt::format(
                "[[surface]]\nface = \"{0}\"\nshape = \"parallelogram\"\ncorner = [{1}, {1}, {2}]\n"
                "edge_u = [1, 0, 0]\nedge_v = [0, 1, 0]\nflip = {3}\n",
                face, x, x + face, face == 1);
        return text;
    };
    const auto plan_at = [&](double x) { return plan_in(scene_at(x), study_text("trials = 9", rays_method)); };
    const StudyPlan far = plan_at(10'000);
    EXPECT_EQ(farthest_coordinate(far.scenes.front()), 1);
    EXPECT_EQ(far.scenes.front().faces, (std::vector<std::string>{"0", "1"}));
    // Random numbers remain those of the file, and scenes near the origin stay where they are.
    EXPECT_EQ(far.scenes.front().canonical, make_scene(far.spec.scenes.front()).canonical);
    EXPECT_EQ(farthest_coordinate(plan_at(7).scenes.front()), 8);
    EXPECT_EQ(known_factors(far.scenes.front()).at(0, 1), known_factors(plan_at(0).scenes.front()).at(0, 1));
}

std::vector<std::string> warnings_of_sobol(std::string_view lines) {
    return plan_of(study_text("trials = 9",
                              "[[method]]\nname = \"S\"\nsampler = \"sobol\"\nestimator = "
                              "\"ray_shooting\"\n" +
                                  std::string(lines)))
        .warnings;
}

TEST(Plan, WarnsOfSizesThatDoNotSuitTheSampler) {
    EXPECT_THAT(warnings_of_sobol("samples_per_patch = [512, 1024]"), testing::IsEmpty());
    EXPECT_THAT(warnings_of_sobol("samples_per_patch = [512, 625]"),
                testing::ElementsAre(testing::AllOf(testing::HasSubstr("'S'"), testing::HasSubstr("512 = 2^9"))));
}

TEST(Plan, WarnsOfTheSizeOfTheWholeSequence) {
    EXPECT_THAT(warnings_of_sobol("patches_per_face = 9\nsamples_per_patch = 128"), testing::IsEmpty());
    EXPECT_THAT(warnings_of_sobol("patches_per_face = 9\nsamples_per_patch = 128\nallocation = \"face\""),
                testing::ElementsAre(testing::HasSubstr("1152 points")));
}

TEST(Plan, RefusesMoreUnitsThanCanBeKept) {
    const std::string methods =
        "[[method]]\nname = \"slow\"\nsampler = \"random\"\nestimator = \"ray_shooting\"\n"
        "samples_per_patch = 100000000\n";
    EXPECT_THROW(plan_of(study_text("trials = 4294967295", methods)), UserError);
}

TEST(Plan, CountsRaysAndKernelValues) {
    const StudyPlan plan = plan_of(study_text("trials = 9", std::string(rays_method) + std::string(pdm_method)));
    EXPECT_EQ(evaluations_per_trial(plan, plan.cells[0]), 6u * 4 * 100);
    EXPECT_EQ(evaluations_per_trial(plan, plan.cells[1]), 24u * 20 * 900);
}

TEST(Plan, CountsPointsSharedByAllTargetsOnce) {
    const StudyPlan plan = plan_of(study_text("trials = 9",
                                              "[[method]]\nname = \"p\"\nsampler = \"gauss_legendre\"\n"
                                              "estimator = \"point_to_polygon\"\nnodes = 5\npatches_per_face = 4"));
    EXPECT_EQ(plan.cells.at(0).samples_per_patch, 25u);
    EXPECT_EQ(evaluations_per_trial(plan, plan.cells[0]), 24u * 25);
}

TEST(Plan, AcceptsBothTracersForABox) {
    EXPECT_NO_THROW(
        static_cast<void>(plan_of(study_text("trials = 9", std::string(rays_method) + "tracer = \"box\""))));
    EXPECT_NO_THROW(
        static_cast<void>(plan_of(study_text("trials = 9", std::string(rays_method) + "tracer = \"embree\""))));
}

}  // namespace
}  // namespace ff::studies
