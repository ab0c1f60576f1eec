// Studies in scenes whose surfaces have grids of their own.

#include "core/exact/exact.hpp"
#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"
#include "studies/analysis/analysis.hpp"
#include "studies/diagnostics/variances.hpp"
#include "studies/results/results.hpp"
#include "studies/trials/estimates.hpp"
#include "tests/support/statistical_assertions.hpp"
#include "tests/support/studies.hpp"
#include "tests/unit/studies/quantities.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace ff::studies {
namespace {

using test::pair;
using testing::HasSubstr;

/// A box of 4 x 1 x 2, whose floor is two surfaces of 1 x 1 and 3 x 1.
constexpr std::string_view room = R"(closed = true
surface = [
    { face = "floor", shape = "parallelogram", corner = [0, 0, 0], edge_u = [1, 0, 0], edge_v = [0, 1, 0], grid = [1, 2] },
    { face = "south", shape = "parallelogram", corner = [0, 0, 0], edge_u = [4, 0, 0], edge_v = [0, 0, 2], flip = true, grid = [4, 2] },
    { face = "north", shape = "parallelogram", corner = [0, 1, 0], edge_u = [4, 0, 0], edge_v = [0, 0, 2] },
    { face = "west", shape = "parallelogram", corner = [0, 0, 0], edge_u = [0, 1, 0], edge_v = [0, 0, 2], grid = [1, 2] },
    { face = "east", shape = "parallelogram", corner = [4, 0, 0], edge_u = [0, 1, 0], edge_v = [0, 0, 2], flip = true, grid = [1, 1] },
    { face = "roof", shape = "parallelogram", corner = [0, 0, 2], edge_u = [4, 0, 0], edge_v = [0, 1, 0], flip = true, grid = [4, 1] },
    { face = "floor", shape = "parallelogram", corner = [1, 0, 0], edge_u = [3, 0, 0], edge_v = [0, 1, 0], grid = [3, 1] },
]
)";

/// The same with a floor of one surface, so that hits are counted.
std::string counted_room() {
    std::string text(room);
    text.replace(text.find("edge_u = [1, 0, 0]"), 18, "edge_u = [4, 0, 0]");
    return text.erase(text.rfind("    { face"));
}
const std::string plain_room = counted_room() + "]\n";

StudyPlan grid_plan(std::string_view scene, std::string_view method, int trials = 40) {
    return test::plan_in(scene, test::study_text(fmt::format("trials = {}", trials), method));
}

std::string ray_method(int m, std::string_view more = "") {
    return fmt::format(
        "[[method]]\nname = \"rays\"\nsampler = \"random\"\nestimator = \"ray_shooting\"\n"
        "patches_per_face = {}\nsamples_per_patch = 50\n{}\n",
        m * m, more);
}

TEST(StudiesOfGrids, CountRaysOfEachFace) {
    const StudyPlan planned = grid_plan(plain_room, ray_method(2));
    EXPECT_EQ(evaluations_per_trial(planned, planned.cells[0]), 4u * 50 * (2 + 8 + 1 + 2 + 1 + 4));
    const Store store = test::run(planned);
    const CellEstimates estimates = load_estimates(store, 0);
    const std::array<double, 6> of_face{400, 1600, 200, 400, 200, 800};
    for (int face = 1; face <= 6; ++face) {
        const double n = of_face.at(static_cast<std::size_t>(face - 1));
        EXPECT_EQ(store.series(0, observable::rays, face, 0).value.front(), n);
        EXPECT_EQ(estimates.lattice({QuantityKind::row_sum, face, 0}), 1 / n);
        const int to = face == 1 ? 2 : 1;
        EXPECT_EQ(estimates.lattice({pair, face, to}), 1 / n);
        EXPECT_EQ(estimates.values({pair, face, to})[0], store.series(0, observable::hits, face, to).value[0] / n);
        for (const double sum : estimates.values({QuantityKind::row_sum, face, 0})) EXPECT_EQ(sum, 1);
    }
}

TEST(StudiesOfGrids, CompleteByAreasWhateverTheRays) {
    const Store store = test::run(grid_plan(plain_room, ray_method(1)));
    const CellEstimates direct = load_estimates(store, 0, Completion::direct);
    const CellEstimates reciprocal = load_estimates(store, 0, Completion::reciprocal);
    const Scene& scene = store.plan().scenes.front();
    for (int i = 1; i <= 6; ++i) {
        for (int j = i + 1; j <= 6; ++j) {
            const double ratio = face_area(scene, i - 1) / face_area(scene, j - 1);
            EXPECT_EQ(reciprocal.lattice({pair, j, i}), direct.lattice({pair, i, j}));
            for (std::size_t t = 0; t < direct.trials(); ++t) {
                EXPECT_EQ(reciprocal.values({pair, i, j})[t], direct.values({pair, i, j})[t]);
                EXPECT_NEAR(reciprocal.values({pair, j, i})[t], ratio * direct.values({pair, i, j})[t], 1e-15);
            }
        }
    }
    EXPECT_EQ(reciprocal.lattice({QuantityKind::row_sum, 2, 0}), std::nullopt) << "hits of unlike numbers of rays";
}

// 1500 trials, every estimator and both rooms: t tests at 1e-6 of 30 pairs each, of which a bias of 0.02 is noticed.
TEST(StudiesOfGrids, AreUnbiased) {
    const std::string points =
        "[[method]]\nname = \"points\"\nsampler = \"sobol\"\nestimator = \"point_to_polygon\"\n"
        "samples_per_patch = 16\nallocation = \"face\"\npatches_per_face = 4\n";
    const std::string kernels =
        "[[method]]\nname = \"kernels\"\nsampler = \"random\"\nestimator = \"area_kernel\"\n"
        "map = \"graded\"\nsamples_per_patch = 128\n";
    for (const std::string_view scene : {std::string_view(room), std::string_view(plain_room)}) {
        const Store store =
            test::run(grid_plan(scene, ray_method(1, "allocation = \"face\"") + points + kernels, 1500));
        const Eigen::MatrixXd exact = exact_form_factors(store.plan().scenes.front()).value();
        for (std::size_t cell = 0; cell < 3; ++cell) {
            const CellEstimates estimates = load_estimates(store, cell);
            for (const Quantity quantity : distinct_pairs(6, Completion::direct)) {
                EXPECT_TRUE(test::unbiased(estimates.values(quantity), exact(quantity.from - 1, quantity.to - 1),
                                           {.detects = 0.02}))
                    << cell << ": " << quantity.from << "-" << quantity.to;
            }
        }
    }
}

// As VarianceCheck tests in the cube (false alarm 1e-6, by Holm over all quantities): exact moments take areas and
// grids into account. Weights by patches would make the standard deviations of the floor wrong by a fifth.
TEST(StudiesOfGrids, HaveTheVarianceOfIndependentRays) {
    for (const std::string_view scene : {std::string_view(room), std::string_view(plain_room)}) {
        const auto checks = check_variances(analyse(test::run(grid_plan(scene, ray_method(2), 400))));
        ASSERT_EQ(checks.size(), 1u);
        EXPECT_GT(checks[0].adjusted_p, 1e-6);
        EXPECT_GT(checks[0].smallest_ratio, 0.8);
        EXPECT_LT(checks[0].largest_ratio, 1.25);
        EXPECT_GT(checks[0].quantities.size(), 20u);
    }
}

/// As in PatchErrors: Var F_pj = F_pj (1 - F_pj) / n, here for patches that are whole parts of the grid.
TEST(StudiesOfGrids, HaveBinomialErrorsWithOnePatchPerPart) {
    const Store store = test::run(grid_plan(room, ray_method(1), 400));
    const auto errors = patch_errors(store, 0);
    ASSERT_TRUE(errors);
    ASSERT_EQ(errors->rmse.size(), 21u);
    const auto exact = exact_patch_to_face(store.plan().scenes[0], {1});
    double expected = 0;
    double found = 0;
    for (int p = 0; p < 21; ++p) {
        for (int face = 0; face < 6; ++face) expected += (*exact)(p, face) * (1 - (*exact)(p, face)) / 50 / 5;
        found += errors->rmse[static_cast<std::size_t>(p)] * errors->rmse[static_cast<std::size_t>(p)];
    }
    // 105 pairs of patch and face, 400 trials: the standard error of the mean square is about 1 %.
    EXPECT_NEAR(found / expected, 1, 0.06);
}

TEST(StudiesOfGrids, CountPairsOfPatchesOfDifferentSurfaces) {
    const StudyPlan planned = grid_plan(room,
                                        "[[method]]\nname = \"k\"\nsampler = \"random\"\nestimator = "
                                        "\"area_kernel\"\npatches_per_face = 4\nsamples_per_patch = 3\n");
    const std::uint64_t squares = 2 * 2 + 8 * 8 + 1 + 2 * 2 + 1 + 4 * 4 + 3 * 3;
    EXPECT_EQ(evaluations_per_trial(planned, planned.cells[0]), 3u * 16 * (21 * 21 - squares));
}

TEST(StudiesOfGrids, RefuseMorePatchesThanCanBeNumbered) {
    std::string fine(plain_room);
    fine.replace(fine.find("[4, 2]"), 6, "[1024, 1024]");
    EXPECT_THAT(test::message_of<UserError>([&] { grid_plan(fine, ray_method(64)); }),
                HasSubstr("method 'rays': 4295008256 patches in scene 'scene.toml' (at most 2147483648)"));
}

// Every patch emits what it absorbs, so that exact factors make all of them as bright as one that absorbs all.
TEST(StudiesOfGrids, SendLightBetweenPatches) {
    const std::string light = "[radiosity]\nreflectance = [0.5]\nemission = 0.5\npatch_trials = 3\n";
    const radiosity::Results results =
        radiosity::find_consequences(test::run(grid_plan(room, ray_method(1, "completion = \"reciprocal\"") + light)));
    const radiosity::ExactSystem& between_patches = results.exact_system(0, 0, 1);
    ASSERT_EQ(between_patches.exitance.size(), 21);
    EXPECT_LT((between_patches.exitance.array() - 1).abs().maxCoeff(), 1e-9);
    for (const radiosity::Treatment treatment : {radiosity::Treatment::direct, radiosity::Treatment::balanced}) {
        const radiosity::Consequences* found = results.find(0, treatment, radiosity::Between::patches);
        ASSERT_NE(found, nullptr);
        EXPECT_EQ(found->trials, 3u);
        EXPECT_LT(found->closure_defect.largest, 1e-12);
    }
}

}  // namespace
}  // namespace ff::studies
