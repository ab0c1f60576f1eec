#include "studies/audit/constraint_system.hpp"

#include <gtest/gtest.h>

namespace ff::studies::audit {
namespace {

Constraint sum_is(const std::vector<std::size_t>& variables, Range values) {
    Constraint constraint{.values = values};
    for (const std::size_t v : variables) constraint.terms.push_back({v, 1});
    return constraint;
}

TEST(Propagate, GivesTheMissingPartOfASum) {
    ConstraintSystem system;
    system.variables = {{{0.2, 0.2}, {}}, {{0.3, 0.3}, {}}, {{0, 1}, {}}};
    system.constraints = {sum_is({0, 1, 2}, {1, 1})};
    const auto ranges = propagate(system, {});
    ASSERT_TRUE(ranges);
    EXPECT_NEAR((*ranges)[2].low, 0.5, 1e-12);
    EXPECT_NEAR((*ranges)[2].high, 0.5, 1e-12);
}

TEST(Propagate, SnapsToWholeHits) {
    ConstraintSystem system;
    system.variables = {{{0.21, 0.34}, 10}};
    const auto ranges = propagate(system, {});
    ASSERT_TRUE(ranges);
    EXPECT_NEAR((*ranges)[0].low, 0.3, 1e-12);
    EXPECT_NEAR((*ranges)[0].high, 0.3, 1e-12);
    system.variables = {{{0.21, 0.29}, 10}};
    EXPECT_FALSE(propagate(system, {}));
}

TEST(Propagate, PutsAnErrorOnThePossibleSide) {
    ConstraintSystem system;
    system.variables = {{{0.9, 1.0}, {}}};
    system.constraints = {{.kind = ConstraintKind::deviation, .terms = {{0, 1}}, .values = {2, 3}, .reference = 1}};
    const auto ranges = propagate(system, {});
    ASSERT_TRUE(ranges);
    EXPECT_NEAR((*ranges)[0].low, 0.97, 1e-12);
    EXPECT_NEAR((*ranges)[0].high, 0.98, 1e-12);
}

TEST(Propagate, FindsAnErrorTooLargeForItsValue) {
    ConstraintSystem system;
    system.variables = {{{0.99, 1.01}, {}}};
    system.constraints = {{.kind = ConstraintKind::deviation, .terms = {{0, 1}}, .values = {2, 3}, .reference = 1}};
    EXPECT_FALSE(propagate(system, {}));
}

TEST(Propagate, FindsAnOddTotal) {
    ConstraintSystem system;
    system.variables = {{{0.5, 0.5}, 10}, {{0.3, 0.3}, 10}, {{0.1, 0.2}, 10}};
    system.constraints = {{.kind = ConstraintKind::even, .terms = {{0, 1}, {1, 1}, {2, 1}}}};
    const auto ranges = propagate(system, {});
    ASSERT_TRUE(ranges);
    EXPECT_NEAR((*ranges)[2].low, 0.2, 1e-12);  // 5 + 3 + 2
    system.variables[2].range = {0.1, 0.1};     // 5 + 3 + 1
    EXPECT_FALSE(propagate(system, {}));
}

TEST(Propagate, LeavesOutBlamedSuspects) {
    ConstraintSystem system;
    system.variables = {{{0, 1}, {}}};
    system.constraints = {sum_is({0}, {0.2, 0.2}), sum_is({0}, {0.3, 0.3})};
    system.constraints[0].suspect = 0;
    system.suspects = {{.figures = {0}, .assumption = {}}};
    EXPECT_FALSE(propagate(system, {false}));
    EXPECT_TRUE(propagate(system, {true}));
}

}  // namespace
}  // namespace ff::studies::audit
