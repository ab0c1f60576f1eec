#include "studies/comparison/decisions.hpp"

#include "core/estimators/added.hpp"
#include "core/geometry/scene.hpp"
#include "studies/run/measured_costs.hpp"
#include "studies/scene_files/scene_file.hpp"
#include "tests/support/box_faces.hpp"
#include "tests/support/repetitions.hpp"
#include "tests/support/studies.hpp"
#include "tests/unit/studies/comparison/two_methods.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

namespace ff::studies {
namespace {

std::vector<Contest> parallel_contests(const Store& store, Equal equal) {
    auto contests = hold_contests(store, analyse(store));
    std::erase_if(contests, [&](const Contest& contest) {
        return contest.equal != equal || contest.pair_class != PairClass::parallel;
    });
    return contests;
}

/// As if a trial of each cell had taken so many seconds of processor time, 10 % more or less.
void set_costs(Store& store, const std::vector<double>& seconds) {
    MeasuredCosts costs(store.plan());
    for (const WorkUnit& unit : store.plan().units) {
        const double each = seconds[unit.cell];
        RunProgress progress;
        progress.unit = unit.index;
        progress.processor_seconds = each * static_cast<double>(unit.trials);
        progress.processor_seconds_squared = 1.01 * each * each * static_cast<double>(unit.trials);
        costs.add(progress);
    }
    store.set_context({{std::string(costs_key), costs.in_context()}});
}

double log_width(const Handicap& handicap) {
    return std::log(handicap.interval->high / handicap.interval->low);
}

// Hits of 100 rays are whole numbers: an error of 0.02 or more for the smaller sizes.
TEST(Contests, RepeatSizesBelowTheBudget) {
    const auto contests = parallel_contests(test::store_with_errors({0.04, 0.002, 0.02}), Equal::evaluations);
    ASSERT_EQ(contests.size(), 2u);
    EXPECT_EQ(contests[0].budget, 600);  // six faces
    ASSERT_EQ(contests[0].entrants.size(), 2u);
    EXPECT_EQ(contests[0].entrants[0].cell, 2u);
    EXPECT_NEAR(contests[0].handicaps[0].ratio, 4, 0.01);
    EXPECT_EQ(contests[0].entrants[1].group, 1u);
    // A with 10000 rays has an error of 0.002; the mean of 100 runs of B with 100 the same.
    EXPECT_EQ(contests[1].budget, 60000);
    EXPECT_NEAR(contests[1].handicaps[0].ratio, 1, 0.01);
    EXPECT_EQ(contests[1].entrants[1].group, 0u);
    const auto repeated = std::find_if(contests[1].entrants.begin(), contests[1].entrants.end(),
                                       [](const Entrant& entrant) { return entrant.cell == 2; });
    EXPECT_NEAR(repeated->repeats, 100, 1e-9);
}

// A with 10000 rays against the mean of 100 runs of B.
TEST(Contests, SayHowManyTrialsWouldShowADifference) {
    const auto handicap_of = [](double error_of_a) {
        const auto contests = parallel_contests(test::store_with_errors({0.04, error_of_a, 0.02}), Equal::evaluations);
        return contests.back().handicaps.front();
    };
    EXPECT_FALSE(handicap_of(0.008).times_trials.has_value()) << "shown";
    double before = 1;
    for (const double error_of_a : {0.0023, 0.0022, 0.0021}) {
        const Handicap handicap = handicap_of(error_of_a);
        ASSERT_TRUE(handicap.interval && handicap.times_trials) << error_of_a;
        const double below = std::log(handicap.ratio / handicap.interval->low) / std::log(handicap.ratio);
        EXPECT_GT(*handicap.times_trials, std::pow(below, 2)) << "which would show it in half of all studies";
        EXPECT_LT(*handicap.times_trials, 4 * std::pow(below, 2));
        EXPECT_GT(*handicap.times_trials, before) << "the nearer to each other, the more";
        before = *handicap.times_trials;
    }
}

// The RMSEs are twice the scales. To reach A's 0.004 with 10000 rays, B is between its 0.04 with 100 and its 0.002 with
// 10000: 100 * 100^(ln 10 / ln 20) = 3446. A's 0.08 is more than B has at any size.
TEST(Contests, InterpolateBetweenSizesToReachAnEqualError) {
    const auto contests = parallel_contests(test::store_with_errors({0.04, 0.002, 0.02, 0.001}, R"([[method]]
name = "A"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = [100, 10000]
[[method]]
name = "B"
sampler = "sobol"
estimator = "ray_shooting"
samples_per_patch = [100, 10000]
)"),
                                            Equal::error);
    ASSERT_EQ(contests.size(), 2u);
    EXPECT_NEAR(contests[1].budget, 0.004, 1e-5);
    EXPECT_NEAR(contests[1].handicaps[0].ratio, 10000 / 3446.0, 0.05);
    EXPECT_TRUE(contests[1].handicaps[0].interval->contains(10000 / 3446.0));
    // To B's 0.002 A takes four runs of its largest size.
    EXPECT_NEAR(contests[0].budget, 0.002, 1e-5);
    EXPECT_NEAR(contests[0].handicaps[0].ratio, 4, 0.1);
}

// Adaptive contour integrals of a cube are exact with 100 evaluations a face.
TEST(Contests, PutMethodsThatAreExactBeforeAllOthers) {
    const Store store = test::run(test::plan_of(test::study_text("trials = 20", R"([[method]]
name = "exact"
estimator = "adaptive_contour"
samples_per_patch = 300
[[method]]
name = "A"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = [16, 256]
[[method]]
name = "B"
sampler = "sobol"
estimator = "ray_shooting"
samples_per_patch = [16, 256]
)")));
    const auto contests = parallel_contests(store, Equal::evaluations);
    ASSERT_FALSE(contests.empty());
    for (const Contest& contest : contests) {
        const bool affordable = contest.budget >= 6 * 300;
        EXPECT_EQ(contest.exact, affordable ? std::vector<std::size_t>{0} : std::vector<std::size_t>{});
        ASSERT_EQ(contest.entrants.size(), 2u);
        EXPECT_EQ(contest.entrants[0].group, affordable ? 1u : 0u);
        EXPECT_EQ(contest.handicaps.size(), 1u);
    }
    EXPECT_GE(contests.back().budget, 6 * 300);
    const auto errors = parallel_contests(store, Equal::error);
    ASSERT_FALSE(errors.empty());
    EXPECT_EQ(errors.front().exact, std::vector<std::size_t>{0});
}

// Runs of 100 samples err by 0.02, those of 10000 by 0.004: the mean of 100 small ones is four times better in mean
// square error, if they have no bias. Rays have none. A program may have one of half its spread, which 30 trials do not
// show.
TEST(Contests, AllowForABiasOfUsersCodeThatIsRepeated) {
    add(std::make_unique<AddedEstimator>(AddedEstimator::Texts{"repeated_program", "", ""}, program_traits(true, true),
                                         nullptr, nullptr));
    const auto last_contest = [](std::string_view small) {
        const auto plan = test::plan_of(test::study_text("trials = 30", fmt::format(R"([[method]]
name = "small"
{}
samples_per_patch = 100
[[method]]
name = "large"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = 10000
)",
                                                                                    small)));
        const Store store = test::fill(plan, [](std::size_t cell, std::uint64_t trial, int from, int to) {
            std::mt19937_64 bits(1000 * trial + 100 * cell + static_cast<std::uint64_t>(10 * from + to));
            return (test::are_opposite(from, to) ? 0.1998249 : 0.20004378) +
                   std::normal_distribution<double>(0, cell == 0 ? 0.02 : 0.004)(bits);
        });
        return parallel_contests(store, Equal::evaluations).back();
    };
    const Contest of_rays = last_contest("sampler = \"sobol\"\nestimator = \"ray_shooting\"");
    EXPECT_EQ(of_rays.entrants.front().cell, 0u);
    EXPECT_TRUE(of_rays.handicaps.front().apart);
    const Contest of_program = last_contest("estimator = \"repeated_program\"");
    EXPECT_EQ(of_program.entrants.front().cell, 0u);
    EXPECT_NEAR(of_program.entrants.front().repeats, 100, 1e-9);
    EXPECT_GT(of_program.handicaps.front().ratio, 2);
    EXPECT_FALSE(of_program.handicaps.front().apart);
}

TEST(Contests, NeedMeasuredCostsAtEqualTime) {
    Store store = test::store_with_errors({0.04, 0.002, 0.02});
    EXPECT_TRUE(parallel_contests(store, Equal::processor_time).empty());
    set_costs(store, {1e-3, 0.1, 4e-3});
    const auto contests = parallel_contests(store, Equal::processor_time);
    ASSERT_EQ(contests.size(), 3u);
    // In 4 ms A runs four times with 100 rays, and has the error of B. At 0.1 s B runs 25 times. 10 ms are round.
    EXPECT_NEAR(contests[0].budget, 4e-3, 1e-7);
    EXPECT_NEAR(contests[0].handicaps[0].ratio, 1, 0.01);
    EXPECT_EQ(contests[1].budget, 1e-2);
    EXPECT_NEAR(contests[2].handicaps[0].ratio, 4, 0.04);
    // The noise of the costs is in the intervals.
    const auto of_evaluations = parallel_contests(store, Equal::evaluations);
    EXPECT_GT(log_width(contests[2].handicaps[0]), log_width(of_evaluations[1].handicaps[0]));
}

TEST(RoundTime, IsItselfForPowersOfTen) {
    for (int power = -9; power < 5; ++power) {
        const double time = std::pow(10, power);
        EXPECT_EQ(round_time_from(time), time);
        EXPECT_EQ(round_time_from(0.7 * time), time);
        EXPECT_EQ(round_time_from(1.1 * time), std::pow(10, power + 1));
    }
}

TEST(Contests, CompareMethodsThatShareRandomNumbersTrialByTrial) {
    const auto methods = [](std::string_view other) {
        return fmt::format(R"([[method]]
name = "direct"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = 100
[[method]]
name = "other"
{}
estimator = "ray_shooting"
samples_per_patch = 100
)",
                           other);
    };
    const auto width = [&](std::string_view other, Equal equal) {
        Store store = test::run(test::plan_of(test::study_text("trials = 200", methods(other))));
        set_costs(store, {0.1, 0.1});
        return log_width(parallel_contests(store, equal).at(0).handicaps.at(0));
    };
    const char* const shared = "sampler = \"random\"\ncompletion = \"reciprocal\"";
    const char* const independent = "sampler = \"random_mt\"\ncompletion = \"reciprocal\"";
    EXPECT_LT(width(shared, Equal::evaluations), 0.9 * width(independent, Equal::evaluations));
    // What clocks leave uncertain is not shared.
    EXPECT_LT(width(shared, Equal::processor_time), 0.95 * width(independent, Equal::processor_time));
    EXPECT_GT(width(shared, Equal::processor_time), 1.1 * width(shared, Equal::evaluations));
}

// Eight copies of one method with different random numbers. All intervals hold in 95 of 100 studies: that they do not
// in more than 8 of 30 has a probability of 1e-5. Separate intervals would fail for some pair in half of the studies
// or more; then 8 or fewer are seen with a probability of 0.008 (nightly 12 of 60: 7e-6 and 2e-6).
TEST(Contests, HaveSimultaneousIntervals) {
    std::string methods;
    for (int i = 0; i < 8; ++i) {
        methods += fmt::format(
            "[[method]]\nname = \"{}\"\nsampler = \"random\"\nestimator = \"ray_shooting\"\nsizes = [{{ "
            "samples_per_patch = {} }}]\n",
            i, 96 + i);
    }
    const std::uint64_t studies = test::repetitions(30, 60);
    int failures = 0;
    for (std::uint64_t seed = 0; seed < studies; ++seed) {
        const auto text =
            fmt::format("[study]\nname = \"test\"\nscene = \"cube\"\nseed = {}\ntrials = 30\n{}", seed, methods);
        const auto contests = parallel_contests(test::run(test::plan_of(text)), Equal::evaluations);
        const bool wrong = std::any_of(contests.begin(), contests.end(), [](const Contest& contest) {
            return std::any_of(contest.handicaps.begin(), contest.handicaps.end(),
                               [](const Handicap& handicap) { return handicap.apart; });
        });
        if (wrong) ++failures;
    }
    EXPECT_LE(failures, test::is_nightly() ? 12 : 8);
}

TEST(PairKind, IsThatOfTheWorstPairOfAClass) {
    const auto kind = [](std::string_view scene, PairClass pair_class) {
        return pair_kind(make_scene(std::string(scene)), pair_class);
    };
    EXPECT_EQ(kind("cube", PairClass::parallel), PairKind::parallel);
    EXPECT_EQ(kind("cube", PairClass::adjacent), PairKind::adjacent);
    EXPECT_EQ(kind("box:1x1x16", PairClass::adjacent), PairKind::adjacent);
    EXPECT_EQ(kind("parallel_squares_far", PairClass::parallel), PairKind::small);
    EXPECT_EQ(kind("squares_blocked:0.5", PairClass::parallel), PairKind::occluded);
    EXPECT_EQ(kind("nested_cubes:3", PairClass::adjacent), PairKind::occluded_adjacent);
    EXPECT_EQ(kind("coaxial_discs_equal", PairClass::parallel), PairKind::curved);
    EXPECT_EQ(kind("cylinder_wall", PairClass::adjacent), PairKind::curved_adjacent);
}

TEST(Decisions, CountTheScenesWhereAMethodIsBest) {
    const auto plan = test::plan_of(R"([study]
name = "test"
scene = ["cube", "box:2x1x1", "squares_blocked"]
trials = 30
seed = 1
inapplicable = "skip"
[[method]]
name = "rays"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = 256
[[method]]
name = "polygons"
sampler = "sobol"
estimator = "visible_polygon"
samples_per_patch = 256
[[method]]
name = "unoccluded"
sampler = "sobol"
estimator = "point_to_polygon"
samples_per_patch = 256
[[method]]
name = "kernel"
sampler = "random"
estimator = "area_kernel"
samples_per_patch = 256
)");
    const Store store = test::run(plan);
    const auto decisions = decide(plan, hold_contests(store, analyse(store)), Equal::evaluations);
    const auto of_kind = [&](PairKind kind) -> const Decision& {
        return *std::ranges::find(decisions, kind, &Decision::kind);
    };
    EXPECT_EQ(of_kind(PairKind::parallel).cases, 2u);
    EXPECT_EQ(of_kind(PairKind::occluded).cases, 1u);
    const auto& occluded = of_kind(PairKind::occluded).choices;
    ASSERT_EQ(occluded.size(), 3u);
    EXPECT_EQ(plan.spec.methods[occluded[0].method].name, "polygons");
    EXPECT_EQ(occluded[0].best, 1u);
    EXPECT_EQ(occluded[1].best, 0u);
    EXPECT_GT(occluded[1].largest_handicap, 4);
    // Contests at one time decide as those of evaluations do.
    auto timed = hold_contests(store, analyse(store));
    std::erase_if(timed, [](const Contest& contest) { return contest.equal != Equal::evaluations; });
    for (Contest& contest : timed) contest.equal = Equal::processor_time;
    EXPECT_TRUE(decide_by_time(plan, timed).empty());  // their budgets are not round
    for (Contest& contest : timed) contest.budget = 0.1;
    const auto by_time = decide_by_time(plan, timed);
    ASSERT_EQ(by_time.size(), 1u);
    EXPECT_EQ(by_time[0].seconds, 0.1);
    const auto& in_time = *std::ranges::find(by_time[0].decisions, PairKind::occluded, &Decision::kind);
    EXPECT_EQ(plan.spec.methods[in_time.choices[0].method].name, "polygons");
    EXPECT_EQ(in_time.equal, Equal::processor_time);
    // The kernel has no variance where faces touch.
    const Decision& adjacent = of_kind(PairKind::adjacent);
    const auto kernel = std::ranges::find(adjacent.choices, std::size_t{3}, &Choice::method);
    ASSERT_NE(kernel, adjacent.choices.end());
    EXPECT_EQ(kernel->ran, adjacent.cases);
    EXPECT_EQ(kernel->entered, 0u);
}

}  // namespace
}  // namespace ff::studies
