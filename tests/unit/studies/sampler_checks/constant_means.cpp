#include "tests/unit/studies/sampler_checks/made_samplers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// Seeds are fixed. All checks of a sampler together fail a sound one with a probability of 1e-3 at most; what is broken
// below is missed with a probability below 1e-9, by the powers of its means in sampler_checks.cpp.

namespace ff::studies {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr const char* mean_of_steps = "mean of steps across the axes";

test::Rows shifted_rows(std::size_t n, std::size_t /*d*/, std::mt19937_64& random) {
    const double shift = test::uniform(random);
    test::Rows rows;
    for (std::size_t i = 0; i < n; ++i)
        rows.push_back({std::fmod(static_cast<double>(i) / static_cast<double>(n) + shift, 1.0)});
    return rows;
}

SamplerChecks checks_of(const test::MakeRows& rows, std::uint64_t n, std::uint64_t trials) {
    return check_sampler(test::sampler_of("made", rows)->entry(), {.points = n, .dimension = 1, .trials = trials});
}

void expect_sound(const SamplerChecks& checks, std::uint64_t n) {
    EXPECT_THAT(test::found(checks, SamplerVerdict::fail), IsEmpty()) << n;
    EXPECT_THAT(test::found(checks, SamplerVerdict::inconclusive), IsEmpty()) << n;
    EXPECT_THAT(test::found(checks, SamplerVerdict::pass, mean_of_steps), SizeIs(1)) << n;
}

// A third of the points lies below 1/3 in every set; at multiples of 40 points 19/40 below the plane, too.
TEST(ConstantMeans, PassWhereTheyAreRight) {
    for (const std::uint64_t n : {3u, 12u, 120u, 1200u}) {
        for (const char* const name : {"latin_hypercube", "hammersley"}) {
            const auto checks = check_sampler(samplers::find(name), {.points = n, .dimension = 1});
            expect_sound(checks, n);
            EXPECT_THAT(checks.not_asked, Contains(HasSubstr("trials independent, steps across the axes: its mean")));
        }
    }
    for (const std::uint64_t n : {6u, 12u, 30u, 60u, 120u}) expect_sound(checks_of(shifted_rows, n, 8000), n);
}

TEST(ConstantMeans, FailWhereManyTrialsHaveOneWrongValue) {
    const auto squeezed = [](double from, double width) {
        return [=](std::size_t n, std::size_t d, std::mt19937_64& random) {
            auto rows = test::latin_rows(n, d, random);
            for (auto& row : rows) row[0] = from + width * row[0];
            return rows;
        };
    };
    for (const auto& [from, width] : {std::pair{1.0 / 3, 2.0 / 3}, std::pair{0.0, 1.0 / 3}, std::pair{0.0, 2.0 / 3}}) {
        const auto many = checks_of(squeezed(from, width), 12, 1000);
        EXPECT_THAT(test::found(many, SamplerVerdict::fail, mean_of_steps), SizeIs(1)) << from << ' ' << width;
        const auto few = checks_of(squeezed(from, width), 12, 3);
        EXPECT_THAT(test::found(few, SamplerVerdict::fail), IsEmpty()) << from << ' ' << width;
        EXPECT_THAT(test::found(few, SamplerVerdict::inconclusive, mean_of_steps), SizeIs(1)) << from << ' ' << width;
    }
}

// Right values of few trials leave room for others that the trials have missed.
TEST(ConstantMeans, AreInconclusiveInFewTrials) {
    const auto latin = [](auto n, auto d, auto& random) { return test::latin_rows(n, d, random); };
    EXPECT_THAT(test::found(checks_of(latin, 12, 100), SamplerVerdict::inconclusive, mean_of_steps), SizeIs(1));
    EXPECT_THAT(test::found(checks_of(latin, 12, 500), SamplerVerdict::pass, mean_of_steps), SizeIs(1));
}

// The middles of 120 slices have all three means right.
TEST(ConstantMeans, LeaveTheIndependenceOfEqualTrialsOpen) {
    const auto middles = [](std::size_t n, std::size_t /*d*/, std::mt19937_64& /*random*/) {
        test::Rows rows;
        for (std::size_t i = 0; i < n; ++i) rows.push_back({(static_cast<double>(i) + 0.5) / static_cast<double>(n)});
        return rows;
    };
    const auto checks = checks_of(middles, 120, 1000);
    EXPECT_THAT(test::found(checks, SamplerVerdict::inconclusive, "trials independent"),
                testing::ElementsAre(HasSubstr("so that means differ")));
}

}  // namespace
}  // namespace ff::studies
