#include "studies/audit/spread.hpp"
#include "studies/audit/scene_facts.hpp"

#include "tests/unit/studies/audit/simulated_tables.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace ff::studies::audit {
namespace {

/// The row sums of "MC" in the simulated tables, their deviations from 1 multiplied by `factor`,
/// known to within `room`.
std::optional<JointDistance> spread_of_sums(std::uint64_t seed, double factor, double room = 0) {
    const PublishedTables tables = test::simulate_tables(seed);
    const SceneFacts facts = scene_facts(tables);
    DistributionCache cache;
    std::vector<SampledValue> values;
    for (std::size_t f = 0; f < tables.figures.size(); ++f) {
        const Figure& figure = tables.figures[f];
        if (figure.method != "MC" || figure.kind != FigureKind::row_sum) continue;
        const double value = 1 + factor * (parse_printed(figure.printed)->value() - 1);
        values.push_back({f, {value - room, value + room}});
    }
    const std::uint64_t rays = std::uint64_t{36} * 700;
    const auto& distribution = cache.at(facts, 36, rays, Completion::reciprocal);
    return weigh_spread(tables, facts, distribution.value(), rays, values);
}

TEST(WeighSpread, HasOneDegreeOfFreedomLessThanFaces) {
    // Six sums, the first fixed by closure.
    EXPECT_EQ(spread_of_sums(1, 1)->chi_squared.freedom, 5u);
}

TEST(WeighSpread, IsUniformOverTrueTables) {
    // 60 tables; P(|share below the median - 1/2| > 0.27) < 1e-4 for a correct test. It notices a covariance that is
    // wrong by a factor of 2 with power .98 (chi-squared of 5 degrees of freedom: P(X/2 < median) = .87).
    int below = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) below += spread_of_sums(seed, 1)->too_far < 0.5 ? 1 : 0;
    EXPECT_GT(below, 13);
    EXPECT_LT(below, 47);
}

TEST(WeighSpread, NoticesValuesTooFarAndTooClose) {
    EXPECT_LT(spread_of_sums(1, 10)->too_far, 1e-6);
    EXPECT_LT(spread_of_sums(1, 0.01)->too_close, 1e-6);
}

// Sums of 25200 rays have standard deviations of about 0.004.
TEST(WeighSpread, LeavesRoomForUnprintedDigits) {
    EXPECT_GT(spread_of_sums(1, 10, 0.05)->too_far, 0.01);
    EXPECT_GT(spread_of_sums(1, 0.01, 0.005)->too_close, 0.01);
}

TEST(WeighReadings, RefutesTheWrongNumberOfRays) {
    PublishedTables tables = test::simulate_tables(3);
    tables.readings.push_back(
        {.table = "sums", .statement = "half as many", .stated_in = {}, .rays_per_face = {1, 12600}});
    tables.readings.push_back({.table = "sums", .statement = "another", .stated_in = {}, .rays_per_face = {1, 30000}});
    DistributionCache cache;
    const auto readings =
        weigh_readings(tables, scene_facts(tables), {Rounding::rounded, Layout::significant_digits, 6}, cache);
    ASSERT_EQ(readings.size(), 3u);
    EXPECT_EQ(readings[0].log_odds, 0);
    EXPECT_FALSE(readings[0].refuted);
    EXPECT_LT(readings[1].log_odds, 0);
    EXPECT_LT(readings[2].log_odds, 0);
}

}  // namespace
}  // namespace ff::studies::audit
