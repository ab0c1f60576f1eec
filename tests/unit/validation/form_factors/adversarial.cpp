#include "tests/validation/form_factors/adversarial.hpp"

#include "studies/form_factors/form_factors.hpp"
#include "tests/support/repetitions.hpp"
#include "tests/support/statistical_assertions.hpp"
#include "tests/validation/form_factors/coverage.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace ff::studies::form_factors {
namespace {

RateTable measured(std::uint64_t scenes, double shrink) {
    FormFactorCoverageOptions options;
    options.scenes = {"cube_adjacent_faces"};  // nothing is sampled there
    options.adversarial = scenes;
    options.shrink = shrink;
    options.threads = 2;
    return measure_form_factor_coverage(options).adversarial;
}

// Intervals hold in at least 0.95 of all random scenes (alpha 1e-3). With probability 0.9, 0.85 would be noticed in the
// scenes of a push, and 0.93 in those of a night.
TEST(AdversarialScenes, AreCoveredByTheirIntervals) {
    const std::uint64_t scenes_of_a_kind = test::repetitions(40, 900);
    const double detects = scenes_of_a_kind < 900 ? 0.1 : 0.02;
    const RateTable table = measured(scenes_of_a_kind, 1);
    const stats::Proportion held = table.rates[table.rates.size() - 2].counts;
    EXPECT_TRUE(test::has_probability_at_least(held.hits, held.trials, 0.95,
                                               {.alpha = 1e-3, .detects = detects, .power = 0.9}));
    EXPECT_EQ(table.rates.back().counts.hits, 0u) << "scenes that miss with too many of their seeds";
}

// Checks the check: intervals that are much too narrow miss too often, and without any width they miss the same scenes
// again and again.
TEST(AdversarialScenes, AreMissedByTooNarrowIntervals) {
    RateTable table = measured(20, 0.02);
    EXPECT_FALSE(holds(table.rates[table.rates.size() - 2], 0.95));
    table = measured(20, 0);
    EXPECT_GT(table.rates.back().counts.hits, 0u);
}

// Intervals of far more points hold the exchange that the scene states, at a level that leaves no room for chance.
TEST(AdversarialScenes, StateTheirExchangeCorrectly) {
    for (const Trap trap : traps) {
        for (std::uint32_t replicate = 0; replicate < (trap == Trap::many_faces ? 1 : 3); ++replicate) {
            stats::Draws draws({}, stats::Resampling::simulation, replicate);
            const AdversarialScene drawn = draw_adversarial(trap, draws);
            Request request;
            request.tolerance = trap == Trap::many_faces || trap == Trap::ball ? 1e-5 : 5e-7;
            request.level = 0.999999;
            request.max_samples = trap == Trap::many_faces ? 20'000'000 : 1'000'000;
            request.threads = 2;
            const Matrix matrix = find_matrix(drawn.scene, request);
            for (const KnownExchange& known : drawn.known) {
                const FaceExchange found = matrix.exchange(known.from, known.to);
                EXPECT_LE(found.low - drawn.error, known.area) << name(trap) << replicate << ": " << known.to;
                EXPECT_GE(found.high + drawn.error, known.area)
                    << name(trap) << replicate << ": " << known.to << (found.is_sampled() ? " sampled" : " computed")
                    << ", too low by " << known.area - found.high << ", error " << drawn.error << ", half "
                    << half_width(found);
            }
        }
    }
}

}  // namespace
}  // namespace ff::studies::form_factors
