#include "tests/unit/studies/sampler_checks/made_samplers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// Whether values repeat, or lie on a grid, is exact here: neither a sound nor a broken sampler is misjudged by chance.

namespace ff::studies {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

enum class Shift { none, any, of_256 };

/// A regular grid of k^d points, k = n^(1/d).
test::MakeRows grid(Shift shift) {
    return [shift](std::size_t n, std::size_t d, std::mt19937_64& random) {
        const auto k = static_cast<std::size_t>(std::lround(std::pow(n, 1.0 / static_cast<double>(d))));
        test::Rows rows(n, std::vector<double>(d));
        std::size_t scale = 1;
        for (std::size_t j = 0; j < d; ++j, scale *= k) {
            const double by = shift == Shift::none  ? 0.0
                              : shift == Shift::any ? test::uniform(random)
                                                    : std::floor(256 * test::uniform(random)) / 256;
            for (std::size_t i = 0; i < n; ++i)
                rows[i][j] = std::fmod(static_cast<double>(i / scale % k) / static_cast<double>(k) + by, 1.0);
        }
        return rows;
    };
}

SamplerChecks checks_of(const test::MakeRows& rows, std::uint64_t n, std::size_t d, std::string_view promise) {
    SamplerCheckRequest request{.points = n, .dimension = d, .trials = 200};
    if (!promise.empty()) request.promises = {parse_promise(promise)};
    return check_sampler(test::sampler_of("made", rows)->entry(), request);
}

std::vector<std::string> doubts_of(const test::MakeRows& rows, std::uint64_t n, std::size_t d,
                                   std::string_view promise) {
    return test::found(checks_of(rows, n, d, promise), SamplerVerdict::inconclusive, "values");
}

TEST(ExplainedValues, IncludeThoseOfAPromisedGridOrLattice) {
    const std::pair<std::uint64_t, std::size_t> sizes[] = {{100, 2}, {64, 2}, {49, 2}, {343, 3}, {216, 3}, {81, 4}};
    for (const auto& [n, d] : sizes) {
        for (const Shift shift : {Shift::none, Shift::any}) {
            for (const char* const promise : {"lattice", "stratified"}) {
                const auto checks = checks_of(grid(shift), n, d, promise);
                EXPECT_THAT(test::found(checks, SamplerVerdict::pass, std::string("promise: ") + promise), SizeIs(1));
                EXPECT_THAT(test::found(checks, SamplerVerdict::inconclusive, "values"), IsEmpty()) << n << promise;
                EXPECT_THAT(test::found(checks, SamplerVerdict::note, "values"), testing::Not(IsEmpty())) << n;
            }
            EXPECT_THAT(doubts_of(grid(shift), n, d, ""), testing::Not(IsEmpty())) << n;
        }
    }
}

TEST(ExplainedValues, ExcludeThoseOfACoarseShift) {
    for (const char* const promise : {"lattice", "stratified"})
        EXPECT_THAT(doubts_of(grid(Shift::of_256), 64, 2, promise),
                    testing::ElementsAre(HasSubstr("on a grid of 1/256"), HasSubstr("on a grid of 1/256")))
            << promise;
}

TEST(ExplainedValues, ExcludeThoseOfCoarsePlacesInCells) {
    const auto coarse = [](std::size_t n, std::size_t d, std::mt19937_64& random) {
        auto rows = grid(Shift::none)(n, d, random);
        for (auto& row : rows)
            for (double& x : row) x += std::floor(32 * test::uniform(random)) / 256;
        return rows;
    };
    const auto checks = checks_of(coarse, 64, 2, "stratified");
    EXPECT_THAT(test::found(checks, SamplerVerdict::pass, "promise: stratified"), SizeIs(1));
    EXPECT_THAT(test::found(checks, SamplerVerdict::inconclusive, "values"), SizeIs(4));
}

TEST(ExplainedValues, ExcludeThoseOfABrokenPromise) {
    const auto moved = [](std::size_t n, std::size_t d, std::mt19937_64& random) {
        auto rows = grid(Shift::any)(n, d, random);
        rows[n / 2][0] = rows[n / 2 - 1][0];
        return rows;
    };
    for (const char* const promise : {"lattice", "stratified"}) {
        const auto checks = checks_of(moved, 100, 2, promise);
        EXPECT_THAT(test::found(checks, SamplerVerdict::fail, std::string("promise: ") + promise), SizeIs(1));
        EXPECT_THAT(test::found(checks, SamplerVerdict::inconclusive, "values"), SizeIs(2)) << promise;
    }
}

}  // namespace
}  // namespace ff::studies
