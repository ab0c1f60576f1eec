#include "studies/sampler_checks/structure_checks.hpp"
#include "tests/support/repetitions.hpp"
#include "tests/unit/studies/sampler_checks/made_samplers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

// Seeds are fixed. A sound sampler is doubted with a probability of 1e-6 at most in each check of it; a broken one of
// those below is missed with a probability below 0.01, which only the half-random Latin hypercube comes near.

namespace ff::studies {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Doubts about structure alone: statistical checks have too few trials here.
std::vector<std::string> doubts_of(const samplers::CatalogueEntry& sampler, std::uint64_t points, std::size_t dimension,
                                   std::uint64_t seed = 1, std::uint64_t trials = 1000) {
    const auto checks =
        check_sampler(sampler, {.points = points, .dimension = dimension, .trials = trials, .seed = seed});
    std::vector<std::string> doubts;
    for (const char* const name :
         {"values", "nearly a Latin hypercube", "partly random", "shifted slices", "shifted net"}) {
        const auto some = test::found(checks, SamplerVerdict::inconclusive, name);
        doubts.insert(doubts.end(), some.begin(), some.end());
    }
    return doubts;
}

std::vector<std::string> doubts_of(const test::MakeRows& rows, std::uint64_t points, std::size_t dimension,
                                   std::uint64_t trials = 1000) {
    return doubts_of(test::sampler_of("made", rows)->entry(), points, dimension, 1, trials);
}

TEST(StructureDoubts, SpareTheCatalogueAtItsOwnAndAtOddSizes) {
    const std::uint64_t trials = ff::test::repetitions(200, 1000);
    std::vector<std::uint64_t> sizes{16, 63, 64, 100};
    if (ff::test::is_nightly()) sizes.insert(sizes.end(), {96, 128, 256, 625, 1000});
    for (const auto& sampler : samplers::catalogue()) {
        if (!sampler.info.equal_weights) continue;
        for (const std::uint64_t n : sizes) {
            for (const std::size_t d : {std::size_t{2}, max_dimension}) {
                if (samplers::check_size(sampler.info, n, d).fatal) continue;
                EXPECT_THAT(doubts_of(sampler, n, d, 1, trials), IsEmpty())
                    << sampler.info.name << ' ' << n << ' ' << d;
            }
        }
    }
}

// Two of 20 000 origins may share a coordinate by chance.
TEST(StructureDoubts, SpareOriginsThatMeetByChance) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
        EXPECT_THAT(doubts_of(samplers::find("antithetic_directions"), 40000, 3, seed, 10), IsEmpty()) << seed;
}

TEST(StructureDoubts, SpareAThousandRandomSets) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
        EXPECT_THAT(doubts_of(samplers::find("random"), 64, max_dimension, seed, 100), IsEmpty()) << seed;
}

TEST(StructureDoubts, SpareLatinHypercubesAndNetsMadeElsewhere) {
    EXPECT_THAT(doubts_of([](auto n, auto d, auto& random) { return test::latin_rows(n, d, random); }, 100, 3),
                IsEmpty());
    EXPECT_THAT(doubts_of([](auto n, auto d, auto& random) { return test::net_rows(n, d, random, 0, true); }, 64, 2),
                IsEmpty());
}

TEST(StructureDoubts, FindAHalfRandomLatinHypercube) {
    for (const std::uint64_t n : {64u, 100u}) {
        const auto doubts =
            doubts_of([](auto m, auto d, auto& random) { return test::latin_rows(m, d, random, 0.5); }, n, 2, 3000);
        ASSERT_THAT(doubts, SizeIs(2)) << n;
        EXPECT_THAT(doubts.front(), HasSubstr("partly random: coordinate 0"));
    }
}

TEST(StructureDoubts, FindANetBrokenByAShift) {
    const auto doubts =
        doubts_of([](auto n, auto d, auto& random) { return test::net_rows(n, d, random, 0, false); }, 64, 2);
    ASSERT_THAT(doubts, SizeIs(1));
    EXPECT_THAT(doubts.front(), HasSubstr("a digital net of t 0 in base 2, shifted modulo 1"));
}

TEST(StructureDoubts, FindALatinHypercubeBrokenByAShift) {
    const auto shifted = [](std::size_t n, std::size_t d, std::mt19937_64& random) {
        auto rows = test::latin_rows(n, d, random);
        for (std::size_t j = 0; j < d; ++j) {
            const double shift = test::uniform(random);
            for (auto& row : rows) row[j] = std::fmod(row[j] + shift, 1.0);
        }
        return rows;
    };
    for (const std::uint64_t n : {64u, 128u}) {
        const auto doubts = doubts_of(shifted, n, 3);
        ASSERT_THAT(doubts, SizeIs(1)) << n;
        EXPECT_THAT(doubts.front(), HasSubstr("shifted slices: every coordinate has one point in each of "));
    }
}

TEST(StructureDoubts, FindTheFirstPointDropped) {
    const auto doubts =
        doubts_of([](auto n, auto d, auto& random) { return test::net_rows(n, d, random, 1, true); }, 64, 2);
    ASSERT_THAT(doubts, SizeIs(1));
    EXPECT_THAT(doubts.front(), HasSubstr("62 of 64 slices of coordinate 1 have one point; 100 of 100 sets"));
}

// The check looks for hypercubes with up to four more points; it does not find one with five more.
TEST(StructureDoubts, FindPointsLeftOutOfALargerLatinHypercube) {
    for (std::size_t more = 1; more <= 5; ++more) {
        const auto doubts = doubts_of(
            [more](auto n, auto d, auto& random) {
                auto rows = test::latin_rows(n + more, d, random);
                rows.resize(n);
                return rows;
            },
            100, 3);
        ASSERT_THAT(doubts, SizeIs(more <= 4 ? 1 : 0)) << more;
        if (doubts.empty()) continue;
        EXPECT_THAT(doubts.front(), HasSubstr("a Latin hypercube of 10" + std::to_string(more)));
    }
}

TEST(StructureDoubts, FindAPermutationThatLeavesOutASlice) {
    const auto last_left_out = [](std::size_t n, std::size_t d, std::mt19937_64& random) {
        auto rows = test::latin_rows(n, d, random);
        for (auto& row : rows)
            if (row[0] >= 1 - 1 / static_cast<double>(n)) row[0] = 0.5 * row[0];
        return rows;
    };
    EXPECT_THAT(doubts_of(last_left_out, 100, 2), SizeIs(1));
}

TEST(StructureDoubts, NoteThatAFixedSetIsNearlyALatinHypercube) {
    const auto checks = check_sampler(samplers::find("sobol_raw"), {.points = 64, .dimension = 4});
    EXPECT_THAT(test::found(checks, SamplerVerdict::note, "nearly a Latin hypercube"), SizeIs(1));
    EXPECT_THAT(test::found(checks, SamplerVerdict::inconclusive), IsEmpty());
}

TEST(StructureDoubts, FindAFewValuesForManyPoints) {
    const auto middles = [](std::size_t n, std::size_t d, std::mt19937_64& random) {
        auto rows = test::random_rows(n, d, random);
        for (auto& row : rows) row[2] = (std::floor(8 * row[2]) + 0.5) / 8;
        return rows;
    };
    const auto doubts = doubts_of(middles, 64, 3);
    ASSERT_THAT(doubts, SizeIs(2));
    EXPECT_THAT(doubts[0], HasSubstr("coordinate 2: as few as 8 values in 64 points"));
    EXPECT_THAT(doubts[1], HasSubstr("coordinate 2: all 8 values in 100 sets lie on a grid of 1/8"));
    const auto drawn_anew = [](std::size_t n, std::size_t d, std::mt19937_64& random) {
        auto rows = test::random_rows(n, d, random);
        for (std::size_t i = 0; i < n; ++i) rows[i][1] = rows[i % 8][1];
        return rows;
    };
    EXPECT_THAT(doubts_of(drawn_anew, 64, 4), SizeIs(1));
}

TEST(StructureDoubts, FindCoarseGridsButSpareTheWordsOfAGenerator) {
    const auto on_grid = [](double steps) {
        return [steps](std::size_t n, std::size_t d, std::mt19937_64& random) {
            auto rows = test::random_rows(n, d, random);
            for (auto& row : rows) row[0] = std::floor(steps * row[0]) / steps;
            return rows;
        };
    };
    for (const double steps : {0x1p11, 0x1p15, 0x1p16, 1000.0, 10000.0, 32767.0}) {
        const auto doubts = doubts_of(on_grid(steps), 64, 2);
        ASSERT_FALSE(doubts.empty()) << steps;
        EXPECT_THAT(doubts.back(), HasSubstr("on a grid of 1/" + std::to_string(std::lround(steps)))) << steps;
    }
    for (const double steps : {1e6, 0x1p24, 0x1p31, 0x1p32})
        EXPECT_THAT(doubts_of(on_grid(steps), 64, 2), IsEmpty()) << steps;
}

TEST(StructureDoubts, NoteARandomisationOfFewOutcomes) {
    const auto sampler = test::sampler_of("four_sets", [](std::size_t n, std::size_t d, std::mt19937_64& random) {
        std::mt19937_64 one_of_four(random() % 4);
        return test::random_rows(n, d, one_of_four);
    });
    const auto checks = check_sampler(sampler->entry(), {.points = 64, .dimension = 2, .trials = 1000});
    EXPECT_THAT(test::found(checks, SamplerVerdict::note, "values"), SizeIs(2));
}

// A radical inverse in base 3 with one permutation for all of its digits has its values on a grid of 1/162.
TEST(StructureDoubts, NoteTheGridOfARadicalInverse) {
    const auto permuted = [](std::size_t n, std::size_t d, std::mt19937_64& random) {
        test::Rows rows(n, std::vector<double>(d));
        for (std::size_t j = 0; j < d; ++j) {
            std::array<std::size_t, 3> digits{0, 1, 2};
            std::shuffle(digits.begin(), digits.end(), random);
            for (std::size_t i = 0; i < n; ++i) {
                std::size_t left = i;
                double scale = 1;
                for (int digit = 0; digit < 30; ++digit, left /= 3)
                    rows[i][j] += static_cast<double>(digits[left % 3]) * (scale /= 3);
            }
        }
        return rows;
    };
    EXPECT_THAT(doubts_of(permuted, 64, 1), IsEmpty());
    const auto sampler = test::sampler_of("permuted", permuted);
    const auto checks = check_sampler(sampler->entry(), {.points = 64, .dimension = 1, .trials = 1000});
    EXPECT_THAT(test::found(checks, SamplerVerdict::note, "values"),
                testing::ElementsAre(HasSubstr("on a grid of 1/162")));
}

}  // namespace
}  // namespace ff::studies
