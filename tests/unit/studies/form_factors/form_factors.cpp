#include "studies/form_factors/form_factors.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/configurations/catalogue.hpp"
#include "core/exact/exact.hpp"
#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"
#include "stats/basics/binomial.hpp"
#include "tests/support/repetitions.hpp"
#include "tests/support/statistical_assertions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

namespace ff::studies::form_factors {
namespace {

Request request_within(double tolerance, std::uint64_t seed = 1) {
    Request request;
    request.tolerance = tolerance;
    request.seed = Seed{seed};
    request.threads = 2;
    return request;
}

/// The matrix of two squares with something in between by rays, stopped when this stage reports its progress for the
/// first time.
Matrix stopped_in(Progress::Stage stage, Request request) {
    std::atomic<bool> stop = false;
    request.cells = false;
    request.stop = &stop;
    request.report = [&](const Progress& progress) { stop = stop || progress.stage == stage; };
    return find_matrix(built_in_scene("squares_blocked"), request);
}

Eigen::MatrixXd dense(const Matrix::Sparse& matrix) {
    return matrix;
}

double factor(const Matrix& matrix, std::size_t from, std::size_t to) {
    return matrix.exchange(from, to).value / matrix.areas[from];
}

TEST(FormFactors, AreExactWhereGeometryAllowsIt) {
    const Scene box = make_box(3, 2, 1);
    const Matrix matrix = find_matrix(box, request_within(1e-12));
    EXPECT_LT((dense(matrix.factors()) - *exact_form_factors(box)).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_EQ(matrix.samples, 0u);
    EXPECT_EQ(matrix.missed(), 0u);
    for (const RowSum& row : matrix.rows) {
        EXPECT_LE(row.low, 1);
        EXPECT_GE(row.high, 1 - 1e-15);
    }
}

TEST(FormFactors, AddUpSurfacesOfAFace) {
    // The floor of a box in four pieces is the floor.
    const Scene whole = make_box(3, 2, 1);
    Scene pieces = whole;
    pieces.empty_box.reset();
    const Parallelogram floor = parallelogram(whole.surfaces[0]);
    pieces.surfaces[0].shape = patch(floor, {2, 2}, 0);
    for (std::uint32_t p = 1; p < 4; ++p) {
        pieces.surfaces.push_back({patch(floor, {2, 2}, p), whole.surfaces[0].normal, 0});
    }
    const Matrix matrix = find_matrix(pieces, request_within(1e-12));
    EXPECT_LT((dense(matrix.factors()) - *exact_form_factors(whole)).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(FormFactors, DoNotDependOnThreads) {
    for (const char* name : {"squares_blocked", "discs_blocked"}) {
        const Scene scene = built_in_scene(name);
        Request request = request_within(2e-3);
        const Matrix two = find_matrix(scene, request);
        request.threads = 1;
        const Matrix one = find_matrix(scene, request);
        EXPECT_EQ(dense(two.factors()), dense(one.factors()));
        EXPECT_EQ(dense(two.half_widths()), dense(one.half_widths()));
        request.seed = Seed{2};
        EXPECT_NE(dense(find_matrix(scene, request).factors()), dense(one.factors()));
    }
}

TEST(FormFactors, ReportWhatABudgetLeavesOut) {
    const Scene scene = built_in_scene("discs_blocked");
    Request request = request_within(1e-5);
    request.max_samples = 2'000'000;
    const Matrix matrix = find_matrix(scene, request);
    EXPECT_EQ(matrix.missed(), 1u);
    EXPECT_LE(matrix.samples, request.max_samples);
    EXPECT_GT(matrix.samples, request.max_samples / 4);
    const FaceExchange& exchange = matrix.exchange(0, 1);
    EXPECT_GT(exchange.high - exchange.low, 2e-5 * matrix.areas[0]);
    request.max_samples = 1000;
    EXPECT_THROW(find_matrix(scene, request), UserError);
}

TEST(FormFactors, MeetARelativeToleranceWhereItIsLarger) {
    Request request = request_within(1e-7);
    const Scene scene = built_in_scene("squares_blocked");
    request.relative = 0.01;
    const Matrix coarse = find_matrix(scene, request);
    const FaceExchange& exchange = coarse.exchange(0, 1);
    EXPECT_EQ(coarse.missed(), 0u);
    EXPECT_LE(worst_half_width(coarse, exchange), 0.01 * factor(coarse, 0, 1));
    EXPECT_NEAR(factor(coarse, 0, 1), *known_form_factor(scene, 0, 1), worst_half_width(coarse, exchange));
    request.relative = 0.001;
    const Matrix fine = find_matrix(scene, request);
    EXPECT_EQ(fine.missed(), 0u);
    EXPECT_LE(worst_half_width(fine, fine.exchange(0, 1)), 0.001 * factor(fine, 0, 1));
    EXPECT_GT(worst_half_width(fine, fine.exchange(0, 1)), 1e-6) << "what is not asked for is not paid for";
    request.relative = 1;
    EXPECT_THROW(find_matrix(scene, request), UserError);
}

TEST(FormFactors, AreBoundedByGeometryWhereThereWasNoTime) {
    const Matrix matrix = stopped_in(Progress::Stage::pilots, request_within(1e-4));
    EXPECT_TRUE(matrix.interrupted);
    EXPECT_EQ(matrix.missed(), 1u);
    const FaceExchange& exchange = matrix.exchange(0, 1);
    EXPECT_EQ(method_of(exchange), "bounds");
    EXPECT_EQ(exchange.low, 0);
    EXPECT_NEAR(exchange.high, 0.199824895698387, 1e-14) << "as if nothing stood in between";
    const std::atomic<bool> stop = true;
    Request request = request_within(1e-4);
    request.stop = &stop;
    const Matrix unknown = find_matrix(built_in_scene("squares_blocked"), request);
    EXPECT_TRUE(unknown.interrupted);
    EXPECT_EQ(method_of(unknown.exchange(0, 1)), "bounds");
    EXPECT_EQ(unknown.exchange(0, 1).low, 0);
    EXPECT_EQ(unknown.exchange(0, 1).high, 1) << "not even that was looked at";
}

// The pilots' interval holds the exact value for at least 0.95 of the seeds; 0.57 would be noticed with probability
// 0.99, and nightly 0.82. Intervals of half the width are noticed.
TEST(FormFactors, HaveValidIntervalsWhenStopped) {
    const double exact = *known_form_factor(built_in_scene("squares_blocked"), 0, 1);
    const std::uint64_t seeds = test::repetitions(44, 200);
    std::uint64_t held = 0;
    std::uint64_t held_by_halves = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const Matrix matrix = stopped_in(Progress::Stage::rounds, request_within(1e-4, seed));
        ASSERT_TRUE(matrix.interrupted);
        const FaceExchange& pair = matrix.exchange(0, 1);
        ASSERT_NE(method_of(pair), "bounds");
        held += pair.low <= exact && exact <= pair.high;
        held_by_halves += std::abs(exact - pair.value) <= (pair.high - pair.low) / 4;
    }
    const test::StatisticalRisk risk{.alpha = 1e-4, .detects = test::is_nightly() ? 0.13 : 0.38, .power = 0.99};
    EXPECT_TRUE(test::has_probability_at_least(held, seeds, 0.95, risk));
    EXPECT_LT(stats::binomial_lower_p({held_by_halves, seeds}, 0.95), 1e-4);
}

TEST(FormFactors, ReportTheirProgress) {
    using Stage = Progress::Stage;
    Request request = request_within(1e-3);
    std::vector<Progress> told;
    request.report = [&](const Progress& progress) { told.push_back(progress); };
    const Scene scene = built_in_scene("nested_cubes");
    const Matrix matrix = find_matrix(scene, request);
    ASSERT_FALSE(told.empty());
    EXPECT_EQ(told.front().stage, Stage::looking);
    EXPECT_EQ(told.back().stage, Stage::rounds);
    EXPECT_EQ(told.back().share, 1);
    EXPECT_EQ(told.back().samples, matrix.samples);
    for (std::size_t i = 0; i + 1 < told.size(); ++i) {
        EXPECT_LE(told[i].samples, told[i + 1].samples);
        EXPECT_LE(told[i].within, told[i + 1].within);
        EXPECT_EQ(told[i].pairs, matrix.pairs());
    }
}

TEST(FormFactors, StayBelowTheUnoccludedValue) {
    // A single blocker hides everything: that is proved, not sampled.
    Scene scene = built_in_scene("squares_blocked");
    Parallelogram& blocker = parallelogram(scene.surfaces[2]);
    blocker = {{-1, -1, 0.5}, {3, 0, 0}, {0, 3, 0}};
    const Matrix proved = find_matrix(scene, request_within(1e-3));
    EXPECT_LT(proved.exchange(0, 1).high, 1e-13);
    // Two blockers do so together: the visible part is empty everywhere.
    Scene two = scene;
    two.surfaces.push_back(two.surfaces[2]);
    parallelogram(two.surfaces[2]).edge_u *= 0.51;
    parallelogram(two.surfaces[3]) = {{0.49, -1, 0.51}, {1.51, 0, 0}, {0, 3, 0}};
    Request request = request_within(1e-3);
    const Matrix seen = find_matrix(two, request);
    EXPECT_EQ(method_of(seen.exchange(0, 1)), "cells");
    EXPECT_LT(seen.exchange(0, 1).high, 1e-13);
    // That no ray arrives proves nothing.
    request.cells = false;
    const FaceExchange exchange = find_matrix(two, request).exchange(0, 1);
    EXPECT_LT(exchange.value, 1e-13);
    EXPECT_EQ(exchange.low, 0);
    EXPECT_GT(exchange.high, 1e-8) << "no hits are no proof";
    EXPECT_LE(exchange.high, 1e-3);
    // A blocker beside the line of sight hides nothing: the value is that of nothing in between, and clipped there.
    blocker = {{0.4, 1.2, 0.5}, {0.1, 0.1, 0}, {0.1, -0.1, 0.2}};
    const Matrix clear = find_matrix(scene, request_within(1e-3));
    EXPECT_NEAR(factor(clear, 0, 1), 0.199824895698387, 1e-14);
    EXPECT_LE(clear.exchange(0, 1).high, 0.199824895698387 + 1e-14);
}

TEST(FormFactors, AreRepairedToCloseWithinTheirIntervals) {
    Request request = request_within(1e-3);
    request.repair = true;
    const Scene scene = built_in_scene("nested_cubes");
    const Matrix matrix = find_matrix(scene, request);
    ASSERT_TRUE(matrix.repaired && matrix.repaired->possible);
    EXPECT_GT(matrix.repaired->closure_before, 1e-7);
    EXPECT_LT(matrix.repaired->closure_after, 1e-12);
    EXPECT_LT(matrix.repaired->largest_change, 1e-3);
    const double exact = *known_form_factor(scene, 0, 2);
    EXPECT_LT(std::abs(matrix.repaired->factors.coeff(0, 2) - exact), std::abs(factor(matrix, 0, 2) - exact) + 1e-3);
    EXPECT_THROW(find_matrix(built_in_scene("squares_blocked"), request), UserError) << "it is open";
}

TEST(FormFactors, RefuseUnattainableTolerances) {
    const Scene round = built_in_scene("discs_blocked");
    for (const double tolerance : {0.0, -1.0, 1e-15, 0.5, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_THROW(find_matrix(round, request_within(tolerance)), UserError) << tolerance;
    }
    EXPECT_THROW(find_matrix(round, request_within(1e-7)), UserError) << "rays are in single precision";
    Request request = request_within(1e-3);
    request.level = 1;
    EXPECT_THROW(find_matrix(round, request), UserError);
}

}  // namespace
}  // namespace ff::studies::form_factors
