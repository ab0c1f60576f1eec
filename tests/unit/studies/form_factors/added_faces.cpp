#include "studies/form_factors/amendments.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

namespace ff::studies::form_factors {
namespace {

Request request_with(const std::string& surroundings) {
    Request request;
    request.tolerance = 1e-4;
    request.surroundings = surroundings;
    return request;
}

Matrix matrix_with(const std::string& surroundings) {
    return find_matrix(built_in_scene("squares_blocked"), request_with(surroundings));
}

TEST(Surroundings, AreAnExtraFaceThatReceivesWhatLeaves) {
    const Matrix open = matrix_with("");
    const Matrix closed = matrix_with("sky");
    const std::size_t sky = open.faces();
    ASSERT_EQ(closed.faces(), sky + 1);
    ASSERT_EQ(closed.rows.size(), sky + 1);
    double area = 0;
    for (std::size_t face = 0; face < sky; ++face) {
        const FaceExchange leaves = closed.exchange(face, sky);
        EXPECT_EQ(leaves.method, ExchangeMethod::remainder);
        EXPECT_NEAR(leaves.value / closed.areas[face], 1 - open.rows[face].value, 1e-15);
        EXPECT_NEAR(leaves.low / closed.areas[face], 1 - open.rows[face].high, 1e-15);
        EXPECT_NEAR(leaves.high / closed.areas[face], 1 - open.rows[face].low, 1e-15);
        EXPECT_EQ(closed.rows[face].value, 1);
        for (std::size_t other = 0; other < sky; ++other)
            EXPECT_EQ(closed.exchange(face, other).value, open.exchange(face, other).value);
        area += leaves.value;
    }
    EXPECT_NEAR(closed.areas[sky], area, 1e-15 * area);
    EXPECT_EQ(closed.exchange(sky, sky).high, 0);
    EXPECT_NEAR(closed.rows[sky].value, 1, 1e-15);
    EXPECT_TRUE(std::is_sorted(closed.exchanges.begin(), closed.exchanges.end(), [](const auto& a, const auto& b) {
        return std::pair(a.from, a.to) < std::pair(b.from, b.to);
    }));
    EXPECT_TRUE(is_trusted(with_added_faces(built_in_scene("squares_blocked"), "sky"), closed, 1e-4));
}

TEST(Surroundings, LetAnOpenSceneBeRepaired) {
    Request request = request_with("sky");
    request.repair = true;
    const Matrix matrix = find_matrix(built_in_scene("squares_blocked"), request);
    ASSERT_TRUE(matrix.repaired && matrix.repaired->possible);
    EXPECT_LT(matrix.repaired->closure_after, 1e-12);
    EXPECT_EQ(matrix.repaired->outside, 0u);
}

TEST(Surroundings, ReceiveNothingOfDroppedPairs) {
    Request request = request_with("sky");
    request.drop = 0.5;  // all there is
    const Matrix matrix = find_matrix(built_in_scene("squares_blocked"), request);
    ASSERT_EQ(matrix.dropped, 1u);
    const FaceExchange leaves = matrix.exchange(0, matrix.faces() - 1);
    EXPECT_NEAR(leaves.value / matrix.areas[0] + matrix.rows[0].dropped.value, 1, 1e-15);
}

TEST(Surroundings, AreRefusedWhereNothingLeavesOrTheNameCannotBeUsed) {
    for (const char* name : {"x|y", "=1+1", "two\nlines"}) EXPECT_THROW(matrix_with(name), UserError) << name;
    EXPECT_THROW(find_matrix(built_in_scene("cube"), request_with("sky")), UserError);
    EXPECT_THROW(matrix_with(built_in_scene("squares_blocked").faces.front()), UserError);
}

// The mean of the values and their spread are those of the entry.
TEST(Randomisations, AreTheValuesBehindTheEstimates) {
    Request request = request_with("");
    EXPECT_TRUE(find_matrix(built_in_scene("squares_blocked"), request).randomisations.empty());
    request.randomisations = true;
    for (const bool cells : {true, false}) {
        request.cells = cells;
        const Matrix matrix = find_matrix(built_in_scene("squares_blocked"), request);
        ASSERT_EQ(matrix.randomisations.size(), 1u);
        const PairRandomisations& pair = matrix.randomisations.front();
        EXPECT_EQ(pair.rays_of.has_value(), !cells) << "cells share no points";
        double mean = 0;
        for (const float value : pair.values) mean += value / randomisations;
        const FaceExchange exchange = matrix.exchange(pair.from, pair.to);
        EXPECT_NEAR(mean, exchange.value / matrix.areas[pair.from], 1e-7);
        const auto [least, most] = std::minmax_element(pair.values.begin(), pair.values.end());
        EXPECT_LT(*least, *most);
        EXPECT_LT(*most - *least, 16 * half_width(exchange) / matrix.areas[pair.from]);
    }
}

}  // namespace
}  // namespace ff::studies::form_factors
