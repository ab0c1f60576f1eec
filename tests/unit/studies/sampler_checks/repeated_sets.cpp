#include "studies/sampler_checks/structure_checks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <vector>

// Independent trials fail with a probability of 1e-6 at most. A share of 5 % or more of at least 200 trials that come
// back at one distance is always found.

namespace ff::studies {
namespace {

using testing::HasSubstr;

std::vector<std::uint64_t> drawn_from(std::uint64_t sets, std::size_t trials, std::mt19937_64& random) {
    std::vector<std::uint64_t> prints(trials);
    for (std::uint64_t& print : prints) print = random() % sets;
    return prints;
}

TEST(RepeatedSets, FailWhereTheyRecurAtOneDistance) {
    std::mt19937_64 random(1);
    for (const std::size_t trials : {200U, 1000U, 20000U}) {
        for (const std::size_t distance : {std::size_t{1}, trials / 7, trials / 2}) {
            std::vector<std::uint64_t> prints = drawn_from(~std::uint64_t{0}, trials, random);
            for (std::size_t k = 0; k < trials / 20; ++k) {
                const std::size_t first = k / distance * 2 * distance + k % distance;
                ASSERT_LT(first + distance, trials);
                prints[first + distance] = prints[first];
            }
            const SamplerCheck check = check_repeated_sets(prints);
            EXPECT_EQ(check.verdict, SamplerVerdict::fail) << trials << ' ' << distance;
            EXPECT_THAT(check.found, HasSubstr(" after " + std::to_string(distance) + " trials"));
        }
    }
}

TEST(RepeatedSets, FailWhereAFileWasWrittenTwice) {
    std::mt19937_64 random(2);
    for (const int copies : {2, 3, 4}) {
        const auto once = drawn_from(~std::uint64_t{0}, 60, random);
        std::vector<std::uint64_t> all;
        for (int copy = 0; copy < copies; ++copy) all.insert(all.end(), once.begin(), once.end());
        EXPECT_EQ(check_repeated_sets(all).verdict, SamplerVerdict::fail) << copies;
    }
}

// A sampler may have few different sets: 4 points in the middles of a Latin square have 24.
TEST(RepeatedSets, PassWhereTheyRecurByChance) {
    std::mt19937_64 random(3);
    for (int repetition = 0; repetition < 200; ++repetition) {
        for (const std::uint64_t sets : {1U, 2U, 6U, 24U, 720U, 40320U, 1000000U}) {
            for (const std::size_t trials : {2U, 10U, 200U, 2000U})
                EXPECT_EQ(check_repeated_sets(drawn_from(sets, trials, random)).verdict, SamplerVerdict::pass)
                    << sets << ' ' << trials;
        }
    }
    EXPECT_EQ(check_repeated_sets(drawn_from(~std::uint64_t{0}, 1000, random)).found, "no set is repeated");
}

}  // namespace
}  // namespace ff::studies
