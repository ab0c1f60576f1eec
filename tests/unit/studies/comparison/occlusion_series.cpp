#include "studies/comparison/occlusion_series.hpp"

#include "core/exact/known_factors.hpp"
#include "studies/results/results.hpp"
#include "tests/support/studies.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>

namespace ff::studies {
namespace {

constexpr double point_sigma = 1e-3;  // of the sampled method with one evaluation

/// Scenes in another order than that of their shares.
StudyPlan occlusion_plan(
    std::string_view scenes = R"("squares_blocked:0.8", "squares_blocked:0", "squares_blocked:0.4")") {
    return test::plan_of(fmt::format(
        "[study]\nname = \"o\"\nscene = [{}]\ntrials = 60\nseed = 5\n"
        "[[method]]\nname = \"rule\"\nsampler = \"gauss_legendre\"\nnodes = 2\nestimator = \"area_kernel\"\n"
        "patches_per_face = [1, 4, 16]\n"
        "[[method]]\nname = \"points\"\nsampler = \"random\"\nestimator = \"area_kernel\"\n"
        "samples_per_patch = [16, 256, 4096]\n",
        scenes));
}

/// Points err by `point_sigma` N^`rate`, normally; the rule by `rule(hidden)` N^-1/4 in every trial.
template <class Rule>
std::vector<OcclusionSeries> series_of(const StudyPlan& plan, Rule rule, double rate = -0.5, std::uint64_t seed = 11) {
    std::mt19937_64 bits(seed);
    std::normal_distribution<double> normal;
    const Store store = test::fill(plan, [&](std::size_t index, std::uint64_t, int from, int to) {
        const Cell& cell = plan.cells[index];
        const Scene& scene = plan.scenes[cell.scene];
        const KnownFactors known = known_factors(scene);
        const double patches = cell.subdivision.per_part();
        const double n = static_cast<double>(cell.samples_per_patch) * patches * patches;
        const double hidden = hidden_share(scene, known, from - 1, to - 1).value();
        return known.at(from - 1, to - 1).value() + (cell.deterministic
                                                         ? rule(hidden) * std::pow(n, -0.25)
                                                         : point_sigma * std::pow(n, rate) * normal(bits));
    });
    const Analysis findings = analyse(store);
    return occlusion_series(store, findings, fit_slopes(store, findings));
}

TEST(OcclusionSeries, FindsTheSmallestErrorAsOcclusionGrows) {
    // At 4096 evaluations points err by 1.6e-5; the rule by 1.2e-6 in the open and 1.2e-3 behind the blocker.
    const auto all = series_of(occlusion_plan(), [](double hidden) { return hidden == 0 ? 1e-5 : 1e-2; });
    ASSERT_EQ(all.size(), 1u);
    const OcclusionSeries& series = all.front();
    EXPECT_EQ(series.family, "squares_blocked");
    EXPECT_EQ(series.samples, 4096u);
    ASSERT_EQ(series.scenes.size(), 3u);
    EXPECT_EQ(series.scenes[0].hidden, 0);
    EXPECT_LT(series.scenes[1].hidden, series.scenes[2].hidden);
    EXPECT_EQ(series.scenes[0].least, 0u);
    EXPECT_EQ(series.scenes[1].least, 1u);
    EXPECT_EQ(series.scenes[2].least, 1u);
    for (const HiddenPair& scene : series.scenes) {
        EXPECT_TRUE(scene.decided);
        EXPECT_NEAR(scene.methods[0]->slope->slope.value(), -0.25, 1e-9);
        EXPECT_NEAR(scene.methods[1]->slope->slope.value(), -0.5, 0.1);
        EXPECT_EQ(scene.methods[0]->slower_than_random, scene.hidden > 0);
    }
}

/// Random points are called slower than random points at 5 % one-sided at most: in 40 studies more than 8 times with
/// probability 3e-4. A slope of -0.3 lies 8 standard errors from -0.5.
TEST(OcclusionSeries, CallsASampledMethodSlowerThanRandomPointsWhereItsSlopeShowsIt) {
    const auto times_slower = [](double rate, std::uint64_t studies) {
        int slower = 0;
        for (std::uint64_t seed = 1; seed <= studies; ++seed) {
            const auto all = series_of(
                occlusion_plan(), [](double) { return 1e-5; }, rate, seed);
            slower += std::ranges::any_of(all.front().scenes,
                                          [](const HiddenPair& scene) { return scene.methods[1]->slower_than_random; });
        }
        return slower;
    };
    EXPECT_LE(times_slower(-0.5, 40), 8);
    EXPECT_EQ(times_slower(-0.3, 5), 5);
}

TEST(OcclusionSeries, LeavesOpenWhatTrialsDoNotShow) {
    // The rule errs as points do, in the mean.
    const auto all = series_of(occlusion_plan(), [](double) { return point_sigma * std::pow(4096.0, -0.25); });
    for (const HiddenPair& scene : all.front().scenes) EXPECT_FALSE(scene.decided) << scene.hidden;
}

TEST(OcclusionSeries, NeedsThreeScenesOfAFamily) {
    const auto none =
        series_of(occlusion_plan(R"("squares_blocked:0.8", "squares_blocked:0", "squares_through_aperture")"),
                  [](double) { return 0.0; });
    EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace ff::studies
