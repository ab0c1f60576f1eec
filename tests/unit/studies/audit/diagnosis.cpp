#include "studies/audit/diagnosis.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ff::studies::audit {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// Variables 0, 1, 2 and their sum 3, each printed by a suspect of the same number.
ConstraintSystem sum_of_three(double a, double b, double c, double sum) {
    ConstraintSystem system;
    for (const double value : {a, b, c, sum}) {
        const std::size_t k = system.variables.size();
        system.variables.push_back({{0, 10}, {}});
        system.constraints.push_back({.terms = {{k, 1}}, .values = {value - 0.01, value + 0.01}, .suspect = k});
        system.suspects.push_back({.figures = {k}, .assumption = {}});
    }
    system.constraints.push_back({.relation = Relation::row_sum, .terms = {{0, 1}, {1, 1}, {2, 1}, {3, -1}}});
    return system;
}

TEST(Diagnose, BlamesNothingWithoutAContradiction) {
    const auto found = diagnose(sum_of_three(1, 2, 3, 6.02));
    ASSERT_THAT(found, SizeIs(1));
    EXPECT_THAT(found.front().blamed, IsEmpty());
}

TEST(Diagnose, ListsEveryFigureThatMayBeToBlame) {
    const auto found = diagnose(sum_of_three(1, 2, 3, 7));
    ASSERT_THAT(found, SizeIs(4));
    for (const Diagnosis& d : found) EXPECT_THAT(d.blamed, SizeIs(1));
}

TEST(Diagnose, BlamesTheFigureInWhichTwoConflictsMeet) {
    ConstraintSystem system = sum_of_three(1, 2, 3, 7);
    // A second relation, 3 = 6 * variable 0, clears everyone but the sum.
    system.constraints.push_back({.relation = Relation::row_sum, .terms = {{0, 6}, {3, -1}}});
    const auto found = diagnose(system);
    ASSERT_THAT(found, SizeIs(1));
    EXPECT_THAT(found.front().blamed, ElementsAre(3u));
    EXPECT_NEAR(found.front().ranges[3].middle(), 6, 0.04);
}

TEST(Diagnose, FindsTwoIndependentErrors) {
    ConstraintSystem system = sum_of_three(1, 2, 3, 7);
    system.constraints.push_back({.relation = Relation::row_sum, .terms = {{0, 6}, {3, -1}}});
    system.variables.push_back({{0, 10}, {}});
    for (const double value : {1.0, 1.0, 2.0}) {
        const std::size_t s = system.suspects.size();
        system.constraints.push_back({.terms = {{4, 1}}, .values = {value, value}, .suspect = s});
        system.suspects.push_back({.figures = {s}, .assumption = {}});
    }
    const auto found = diagnose(system);
    EXPECT_THAT(found.front().blamed, ElementsAre(3u, 6u));
}

TEST(Diagnose, NamesACandidateWhereTheFewestCausesCannotBeProven) {
    // No three of 36 figures can be right together, so that all but two are wrong.
    ConstraintSystem system;
    constexpr std::size_t figures = 36;
    for (std::size_t s = 0; s < figures; ++s) system.suspects.push_back({.figures = {s}, .assumption = {}});
    for (std::size_t k = 0; k + 2 < figures; ++k) {
        for (std::size_t j = k + 1; j + 1 < figures; ++j) {
            for (std::size_t i = j + 1; i < figures; ++i) {
                const std::size_t first = system.variables.size();
                for (int n = 0; n < 3; ++n) system.variables.push_back({{0, 1}, {}});
                std::size_t n = first;
                for (const std::size_t s : {k, j, i})
                    system.constraints.push_back({.terms = {{n++, 1}}, .values = {1, 1}, .suspect = s});
                system.constraints.push_back({.relation = Relation::row_sum,
                                              .terms = {{first, 1}, {first + 1, 1}, {first + 2, 1}},
                                              .values = {0, 2},
                                              .suspect = {}});
            }
        }
    }
    const auto found = diagnose(system);
    ASSERT_THAT(found, SizeIs(1));
    EXPECT_THAT(found.front().blamed, SizeIs(figures - 2));
    EXPECT_FALSE(found.front().proven);
}

TEST(FindConflict, IsMinimal) {
    const ConstraintSystem system = sum_of_three(1, 2, 3, 7);
    EXPECT_THAT(find_conflict(system, Blame(4, false)), ElementsAre(0u, 1u, 2u, 3u));
    Blame blame(4, false);
    blame[2] = true;
    EXPECT_THAT(find_conflict(system, blame), IsEmpty());
}

}  // namespace
}  // namespace ff::studies::audit
