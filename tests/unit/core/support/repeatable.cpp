#include "core/support/repeatable.hpp"

#include "core/support/error.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <vector>

namespace ff {
namespace {

constexpr OutsideWords words{"prints", "{seed}", "leave it out"};

/// The trials for which a result was requested. @param result  of a trial
template <class Result, class Telling>
std::vector<std::uint32_t> probes_of(bool randomised, const Result& result, const Telling& telling) {
    std::vector<std::uint32_t> trials;
    Repeatable(randomised, words)
        .expect(
            "mine", "points",
            [&](std::uint32_t trial) {
                trials.push_back(trial);
                return result(trial);
            },
            telling);
    return trials;
}

TEST(Repeatable, ResultsThatDifferBySeedAreAcceptedAtOnce) {
    EXPECT_EQ(probes_of(
                  true, [](std::uint32_t trial) { return trial; }, always_telling),
              (std::vector<std::uint32_t>{0, 0, 1}));
    EXPECT_EQ(probes_of(
                  false, [](std::uint32_t trial) { return trial; }, always_telling)
                  .size(),
              2u);
}

TEST(Repeatable, EqualResultsOfTwoSeedsAreNotRefused) {
    const auto fourth = [](std::uint32_t trial) { return trial % 4 == 3; };
    EXPECT_EQ(probes_of(true, fourth, always_telling), (std::vector<std::uint32_t>{0, 0, 1, 2, 3}));
}

TEST(Repeatable, EqualResultsOfTenSeedsAreRefusedUnlessNothingHappened) {
    const auto same = [](std::uint32_t) { return 5; };
    EXPECT_THROW(probes_of(true, same, always_telling), UserError);
    EXPECT_EQ(probes_of(true, same, [](int result) { return result != 5; }), (std::vector<std::uint32_t>{0, 0, 1}));
    EXPECT_EQ(probes_of(false, same, always_telling).size(), 2u);
}

TEST(Repeatable, ResultsThatDifferForOneSeedAreRefused) {
    int runs = 0;
    EXPECT_THROW(probes_of(
                     true, [&](std::uint32_t) { return ++runs; }, always_telling),
                 UserError);
}

TEST(Repeatable, RefusesResultsThatDependOnTheRequestsBefore) {
    // A cache by seed hides in one process that values come from a generator which all seeds share.
    std::map<std::uint32_t, int> cache;
    int drawn = 0;
    const auto cached = [&](std::uint32_t trial) { return cache.try_emplace(trial, drawn++).first->second; };
    EXPECT_NO_THROW(Repeatable(true, words).expect("mine", "points", cached, always_telling));
    const auto restart = [&] {
        cache.clear();
        drawn = 0;
    };
    restart();
    EXPECT_THROW(Repeatable(true, words).expect("mine", "points", cached, always_telling, restart), UserError);
    const auto sound = [](std::uint32_t trial) { return trial; };
    EXPECT_NO_THROW(Repeatable(true, words).expect("mine", "points", sound, always_telling, restart));
}

}  // namespace
}  // namespace ff
