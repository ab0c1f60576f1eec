#include "studies/form_factors/adversarial.hpp"

#include "studies/form_factors/coverage.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "tests/support/repetitions.hpp"
#include "tests/support/statistical_assertions.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace ff::studies {
namespace {

/// The pooled row of `scenes` random scenes of each kind.
stats::Proportion pooled(std::uint64_t scenes, double shrink) {
    FormFactorCoverageOptions options;
    options.scenes = {"cube_adjacent_faces"};  // nothing is sampled there
    options.adversarial = scenes;
    options.shrink = shrink;
    options.threads = 2;
    return measure_form_factor_coverage(options).adversarial.rates.back().counts;
}

// Intervals hold in at least 0.95 of all random scenes (alpha 1e-3). With probability 0.9, 0.89 would be noticed in the
// 450 scenes of a push, and 0.93 in the 2700 of a night.
TEST(AdversarialScenes, AreHeldByTheirIntervals) {
    const std::uint64_t scenes_of_a_kind = test::repetitions(150, 900);
    const double detects = scenes_of_a_kind < 900 ? 0.06 : 0.02;
    const stats::Proportion held = pooled(scenes_of_a_kind, 1);
    EXPECT_TRUE(test::has_probability_at_least(held.hits, held.trials, 0.95,
                                               {.alpha = 1e-3, .detects = detects, .power = 0.9}));
}

// What they are beside exact values: intervals of far more points hold what the scene says, at a level that leaves no
// room for chance.
TEST(AdversarialScenes, KnowTheirExchange) {
    for (const Obstacle obstacle : obstacles) {
        for (std::uint32_t replicate = 0; replicate < 3; ++replicate) {
            stats::Draws draws({}, stats::Resampling::simulation, replicate);
            const AdversarialScene drawn = draw_adversarial(obstacle, draws);
            FormFactorRequest request;
            request.tolerance = 5e-7;
            request.level = 0.999999;
            request.max_samples = 1'000'000;
            request.threads = 2;
            const FaceExchange found = find_form_factors(drawn.scene, request).exchange(0, 1);
            EXPECT_LE(found.low - drawn.exchange_error, drawn.exchange) << name(obstacle) << replicate;
            EXPECT_GE(found.high + drawn.exchange_error, drawn.exchange) << name(obstacle) << replicate;
        }
    }
}

}  // namespace
}  // namespace ff::studies
