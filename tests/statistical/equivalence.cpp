// Ray shooting is unbiased with every randomised sampler that it can use: shown, not just not refuted, on all pairs of
// faces.
//
// Per sampler: equivalence of all 30 pairs within delta, an intersection-union test, so that a sampler with a bias of
// delta on any pair passes with probability at most alpha = 1e-3, whatever its other pairs do. The number of trials is
// planned from a pilot study with other seeds, so that an unbiased sampler passes on all
// pairs together with probability 0.999 (the pilot's estimate of sigma is raised by its own uncertainty).

#include "core/configurations/built_in_scene.hpp"
#include "core/exact/exact.hpp"
#include "core/geometry/scene.hpp"
#include "stats/basics/moments.hpp"
#include "stats/error_rates/power.hpp"
#include "stats/means/mean_test.hpp"
#include "stats/variances/variance_interval.hpp"

#include "samplers/sampler.hpp"
#include "studies/trials/estimates.hpp"
#include "tests/support/studies.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace ff::studies {
namespace {

constexpr double alpha = 1e-3;
constexpr double power = 0.999;
constexpr std::size_t pilot_trials = 60;

std::vector<std::string_view> samplers_of_rays() {
    std::vector<std::string_view> names;
    for (const auto& entry : samplers::catalogue()) {
        if (entry.info.equal_weights && entry.info.randomised) names.push_back(entry.info.name);
    }
    return names;
}

/// The result that is shown for a sampler.
struct Aim {
    int samples_per_patch;
    double delta;
};

/// 4096 = 2^12 = 8^4 points per patch, sizes that every sampler can do, and a margin of 1 % of a form factor of the
/// cube; 256 = 2^8 = 4^4 and 2.5 % for a sampler that is slow by the plan's cost table.
constexpr Aim fast{4096, 2e-3};
constexpr Aim slow{256, 5e-3};

StudyPlan plan_of(std::string_view sampler, Aim aim, std::size_t trials, int seed) {
    return test::plan_of(
        fmt::format("[study]\nname = \"t\"\nscene = \"cube\"\ntrials = {}\nseed = {}\n"
                    "[[method]]\nname = \"SR\"\nsampler = \"{}\"\nestimator = \"ray_shooting\"\n"
                    "patches_per_face = 4\nsamples_per_patch = {}",
                    trials, seed, sampler, aim.samples_per_patch));
}

Aim aim_for(std::string_view sampler) {
    const StudyPlan plan = plan_of(sampler, fast, 2, 1);
    return expected_seconds_per_trial(plan, plan.cells.front()) < 5e-3 ? fast : slow;
}

Store trials_of(std::string_view sampler, Aim aim, std::size_t trials, int seed) {
    return test::run(plan_of(sampler, aim, trials, seed));
}

/// Upper 99.9 % bound of the standard deviation of a trial, on the worst pair.
double pilot_sigma(std::string_view sampler, Aim aim) {
    const Store store = trials_of(sampler, aim, pilot_trials, 1);
    const CellEstimates estimates = load_estimates(store, 0);
    double largest = 0;
    for (const Quantity pair : distinct_pairs(6, Completion::direct)) {
        const auto moments = stats::moments_of(estimates.values(pair), 0.2);
        if (const auto interval = stats::variance_interval_chi2(moments, 0.998))
            largest = std::max(largest, std::sqrt(interval->high));
    }
    return largest;
}

/// Trials with which an unbiased sampler passes; at least 2.
std::size_t planned_trials(std::string_view sampler, Aim aim) {
    return stats::trials_for_equivalence(aim.delta, pilot_sigma(sampler, aim), {alpha, power}, 30);
}

/// Hits of a cube's faces are not skewed enough to matter.
stats::Interval interval_of_bias(const CellEstimates& estimates, Quantity pair) {
    static const Eigen::MatrixXd exact = exact_form_factors(built_in_scene("cube")).value();
    const double truth = exact(pair.from - 1, pair.to - 1);
    return stats::mean_interval(estimates.values(pair), truth, 1 - 2 * alpha, stats::not_skewed).value();
}

bool lies_within(const stats::Interval& interval, double delta) {
    return -delta < interval.low && interval.high < delta;
}

class RayShooting : public testing::TestWithParam<std::string_view> {};

TEST_P(RayShooting, IsEquivalentToTheExactFactorsOnAllPairs) {
    const Aim aim = aim_for(GetParam());
    const std::size_t trials = planned_trials(GetParam(), aim);
    ASSERT_LE(trials, 2000u) << "too noisy for a quick test";
    const Store store = trials_of(GetParam(), aim, trials, 2);
    const CellEstimates estimates = load_estimates(store, 0);
    for (const Quantity pair : distinct_pairs(6, Completion::direct)) {
        const auto interval = interval_of_bias(estimates, pair);
        EXPECT_TRUE(lies_within(interval, aim.delta))
            << "F " << pair.from << "-" << pair.to << ", " << trials << " trials: bias within [" << interval.low << ", "
            << interval.high << "]";
    }
    EXPECT_EQ(estimates.lost_rays, 0u);
}

INSTANTIATE_TEST_SUITE_P(EverySampler, RayShooting, testing::ValuesIn(samplers_of_rays()),
                         [](const auto& test) { return std::string(test.param); });

TEST(Equivalence, IsNotShownForRaysWithABias) {
    // Real trials, but in each of them 48 of the 16384 rays of face 1 hit face 6 that should not: a bias of 2.93e-3.
    const Store honest = trials_of("random", fast, planned_trials("random", fast), 3);
    const CellEstimates direct = load_estimates(honest, 0);
    const Store biased = test::fill(honest.plan(), [&](std::size_t, std::uint64_t trial, int from, int to) {
        const double value = direct.values({QuantityKind::form_factor, from, to})[trial];
        return from == 1 && to == 6 ? value + 48.0 / 16384 : value;
    });
    EXPECT_TRUE(lies_within(interval_of_bias(direct, {QuantityKind::form_factor, 1, 6}), fast.delta));
    EXPECT_FALSE(
        lies_within(interval_of_bias(load_estimates(biased, 0), {QuantityKind::form_factor, 1, 6}), fast.delta));
}

}  // namespace
}  // namespace ff::studies
