#include "studies/trials/estimates.hpp"

#include "core/exact/exact.hpp"
#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"
#include "tests/support/studies.hpp"
#include "tests/unit/studies/quantities.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ff::studies {
namespace {

using test::pair;
using test::plan_of;

StudyPlan box_plan(std::string_view completion, std::string_view scene = "box:2x1x0.5") {
    return plan_of("[study]\nname = \"t\"\nscene = \"" + std::string(scene) +
                   "\"\ntrials = 20\nseed = 3\n[[method]]\nname = \"SR\"\nsampler = \"random\"\n"
                   "estimator = \"ray_shooting\"\npatches_per_face = 4\nsamples_per_patch = 125\ncompletion = \"" +
                   std::string(completion) + "\"");
}

TEST(DirectEstimates, AreHitsDividedByRaysAndCloseExactly) {
    const Store store = test::run(box_plan("direct"));
    const CellEstimates estimates = load_estimates(store, 0);
    ASSERT_EQ(estimates.trials(), 20u);
    EXPECT_EQ(estimates.samples_of_pair, 500u);
    EXPECT_EQ(estimates.evaluations_per_face, 500u);
    EXPECT_EQ(estimates.lattice({pair, 3, 2}), 1.0 / 500);
    const auto hits = store.series(0, observable::hits, 3, 2).value;
    for (std::size_t t = 0; t < 20; ++t) {
        EXPECT_EQ(estimates.values({pair, 3, 2})[t], hits[t] / 500);
        for (const auto& sums : estimates.row_sums) EXPECT_EQ(sums[t], 1.0);
        EXPECT_EQ(estimates.sum_relative_error[t], 0.0);
    }
}

TEST(ReciprocalEstimates, FollowFromTheSameRaysByTheRatioOfAreas) {
    const Store store = test::run(box_plan("reciprocal"));
    const CellEstimates direct = load_estimates(store, 0, Completion::direct);
    const CellEstimates reciprocal = load_estimates(store, 0);
    const Scene& scene = store.plan().scenes.front();
    bool unequal = false;
    for (int i = 1; i <= 6; ++i) {
        for (int j = i + 1; j <= 6; ++j) {
            const double ratio = face_area(scene, i - 1) / face_area(scene, j - 1);
            unequal = unequal || ratio != 1;
            EXPECT_EQ(reciprocal.values({pair, i, j}), direct.values({pair, i, j}));
            for (std::size_t t = 0; t < direct.trials(); ++t) {
                EXPECT_NEAR(reciprocal.values({pair, j, i})[t], ratio * direct.values({pair, i, j})[t], 1e-15);
            }
        }
    }
    EXPECT_TRUE(unequal);
}

TEST(ReciprocalEstimates, LeaveOnlyTheFirstFaceClosed) {
    for (const char* scene : {"cube", "box:2x1x0.5"}) {
        const CellEstimates estimates = load_estimates(test::run(box_plan("reciprocal", scene)), 0);
        for (int face = 1; face <= 6; ++face) {
            const auto& sums = estimates.values({QuantityKind::row_sum, face, 0});
            const bool always_one = std::all_of(sums.begin(), sums.end(), [](double sum) { return sum == 1.0; });
            EXPECT_EQ(always_one, face == 1) << scene << ", face " << face;
        }
    }
}

TEST(Estimates, SumRowsAndTheirRelativeErrors) {
    // Row i sums to 1 + i / 1000: 100 (0.001 + ... + 0.006) = 2.1 %.
    const StudyPlan plan = plan_of(test::study_text("trials = 2",
                                                    "[[method]]\nname = \"k\"\nsampler = \"random\"\n"
                                                    "estimator = \"area_kernel\"\nsamples_per_patch = 2"));
    const Store store = test::fill(plan, [](std::size_t, std::uint64_t trial, int from, int) {
        return trial == 0 ? (1 + from / 1000.0) / 5 : 0.2;
    });
    const CellEstimates estimates = load_estimates(store, 0);
    for (int face = 1; face <= 6; ++face) {
        EXPECT_NEAR(estimates.values({QuantityKind::row_sum, face, 0})[0], 1 + face / 1000.0, 1e-15);
        EXPECT_NEAR(estimates.values({QuantityKind::row_sum, face, 0})[1], 1, 1e-15);
    }
    EXPECT_NEAR(estimates.values({QuantityKind::sum_relative_error, 0, 0})[0], 2.1, 1e-12);
    EXPECT_NEAR(estimates.values({QuantityKind::sum_relative_error, 0, 0})[1], 0, 1e-12);
    EXPECT_EQ(estimates.lattice({pair, 3, 2}), std::nullopt);
}

TEST(Estimates, CountKernelValuesOfOneFacePairAndOfAllPairsOfAFace) {
    const StudyPlan plan = plan_of(test::study_text("trials = 2",
                                                    "[[method]]\nname = \"k\"\nsampler = \"random\"\nestimator = "
                                                    "\"area_kernel\"\npatches_per_face = 4\nsamples_per_patch = 3"));
    const CellEstimates estimates = load_estimates(test::run(plan), 0);
    EXPECT_EQ(estimates.samples_of_pair, 4u * 4 * 3);
    EXPECT_EQ(estimates.evaluations_per_face, 5u * 4 * 4 * 3);
}

TEST(Estimates, SumTo1BeforeCompletionForPointToPolygon) {
    const std::string lines =
        "[[method]]\nname = \"p\"\nsampler = \"sobol\"\nestimator = \"point_to_polygon\"\n"
        "patches_per_face = 4\nsamples_per_patch = 8\nallocation = \"face\"";
    const Store store = test::run(plan_of(test::study_text("trials = 3", lines)));
    const CellEstimates direct = load_estimates(store, 0);
    EXPECT_EQ(direct.samples_of_pair, 4u * 8);
    const CellEstimates reciprocal = load_estimates(store, 0, Completion::reciprocal);
    for (std::size_t trial = 0; trial < 3; ++trial) {
        EXPECT_NEAR(direct.values({QuantityKind::row_sum, 6, 0})[trial], 1, 1e-14);
        EXPECT_NE(reciprocal.values({QuantityKind::row_sum, 6, 0})[trial], 1);
    }
}

TEST(Estimates, ReportOneLostRay) {
    const StudyPlan plan = box_plan("direct");
    Store store = Store::create_or_resume(test::in_memory, plan);
    UnitRecord record;
    for (std::uint64_t trial = 0; trial < 20; ++trial) {
        for (int from = 1; from <= 6; ++from) {
            for (int to = 1; to <= 6; ++to) {
                const bool lost = trial == 0 && from == 1 && to == 2;
                if (from != to)
                    record.observations.push_back({observable::hits, from, to, trial, std::int64_t{lost ? 99 : 100}});
            }
        }
    }
    record.observations.push_back({observable::lost, 1, 0, 0, std::int64_t{1}});
    store.commit(record);
    const CellEstimates estimates = load_estimates(store, 0);
    EXPECT_EQ(estimates.lost_rays, 1u);
    EXPECT_EQ(estimates.row_sums[0][0], 499.0 / 500);
}

TEST(Estimates, AreRefusedWhenTheStoreLacksRows) {
    Store store = Store::create_or_resume(test::in_memory, box_plan("direct"));
    store.commit({0, {{observable::hits, 1, 2, 0, std::int64_t{500}}}, {}, {}});
    EXPECT_THROW(load_estimates(store, 0), IoError);
}

TEST(Estimates, EqualTheExactFactorsForTheClosedForm) {
    const Store store =
        test::run(plan_of(test::study_text("trials = 9", "[[method]]\nname = \"e\"\nestimator = \"closed_form\"")));
    const CellEstimates estimates = load_estimates(store, 0);
    ASSERT_EQ(estimates.trials(), 1u);
    EXPECT_EQ(estimates.values({pair, 1, 6})[0], exact_form_factor(store.plan().scenes[0], 0, 5));
}

TEST(Quantities, AreAllPairsThenSumsThenTheirError) {
    const auto quantities = all_quantities(load_estimates(test::run(box_plan("direct")), 0));
    ASSERT_EQ(quantities.size(), 30u + 6 + 1);
    EXPECT_EQ(quantities.front(), (Quantity{pair, 1, 2}));
    EXPECT_EQ(quantities[30], (Quantity{QuantityKind::row_sum, 1, 0}));
    EXPECT_EQ(quantities.back(), (Quantity{QuantityKind::sum_relative_error, 0, 0}));
}

TEST(DistinctPairs, AreHalfAsManyUnderReciprocity) {
    EXPECT_EQ(distinct_pairs(6, Completion::direct).size(), 30u);
    const auto half = distinct_pairs(6, Completion::reciprocal);
    EXPECT_EQ(half.size(), 15u);
    for (const Quantity q : half) EXPECT_LT(q.from, q.to);
}

}  // namespace
}  // namespace ff::studies
