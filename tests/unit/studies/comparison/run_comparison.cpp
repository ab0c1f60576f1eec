#include "studies/comparison/run_comparison.hpp"

#include "core/support/error.hpp"
#include "tests/support/repetitions.hpp"
#include "tests/support/statistical_assertions.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

namespace ff::studies {
namespace {

Store made(std::string_view sampler, int seed, int trials = 60, std::string_view more = "") {
    return test::run(test::plan_of(fmt::format(
        "[study]\nname = \"s\"\nscene = \"cube\"\nseed = {}\ntrials = {}\n[[method]]\nname = \"rays\"\nsampler = "
        "\"{}\"\nestimator = \"ray_shooting\"\nsamples_per_patch = 256\n{}",
        seed, trials, sampler, more)));
}

constexpr const char* quadrature = R"([[method]]
name = "PDM"
sampler = "gauss_legendre"
nodes = {}
estimator = "area_kernel"
patches_per_face = 4
)";

// Comparisons of sound runs at 5 % each: a rate above 5 % is claimed by mistake with probability 1e-6, and a rate of
// 29 % (nightly 17 %) is found with probability 0.99.
TEST(RunComparison, CallsSoundRunsDifferentNoMoreOftenThanStated) {
    std::uint64_t alarms = 0;
    const int repeats = test::is_nightly() ? 300 : 100;
    for (int i = 0; i < repeats; ++i) {
        const auto comparison = compare_runs(made("random", 2 * i + 1, 12), made("random", 2 * i + 2, 12));
        EXPECT_EQ(comparison.tests, 62u);
        EXPECT_EQ(comparison.cells.front().basis, Basis::independent);
        alarms += comparison.count(Likeness::different) > 0 ? 1u : 0u;
    }
    EXPECT_TRUE(test::has_probability_at_most(alarms, static_cast<std::uint64_t>(repeats), 0.05,
                                              {.alpha = 1e-6, .detects = test::is_nightly() ? 0.13 : 0.24}));
}

// The bias of patch_centres with one origin on the whole face is many standard errors at these sizes.
TEST(RunComparison, SeesABrokenSamplerInTheMeans) {
    const auto comparison = compare_runs(made("random", 1, 400), made("patch_centres", 2, 400));
    ASSERT_EQ(comparison.count(Likeness::different), 1u);
    EXPECT_LT(comparison.cells.front().mean->adjusted_p, 1e-6);
}

TEST(RunComparison, SeesABrokenSamplerInTheSpread) {
    const auto comparison = compare_runs(made("sobol", 1), made("random", 2));
    const CellComparison& cell = comparison.cells.front();
    EXPECT_EQ(cell.likeness, Likeness::different);
    EXPECT_GE(cell.mean->adjusted_p, 0.05);
    EXPECT_LT(cell.spread->adjusted_p, 0.01);
    EXPECT_GT(cell.spread->size, 1);
    for (const RmseRatio& ratio : cell.ratios) EXPECT_GT(ratio.interval->low, 1);
}

// Halton against Sobol' rays: a few percent on every pair, more than five standard errors of them all together.
TEST(RunComparison, SeesASmallDifferenceOfAllPairsInTheRmse) {
    const auto comparison = compare_runs(made("halton", 1, 400), made("sobol", 2, 400));
    const CellComparison& cell = comparison.cells.front();
    EXPECT_EQ(cell.likeness, Likeness::different);
    EXPECT_GE(cell.mean->adjusted_p, 0.05);
    EXPECT_LT(cell.ratios.back().adjusted_p, cell.spread->adjusted_p / 100);
}

// Values too rare to be met may make up for a spread that trials do not have, not for a mean far from the other.
TEST(RunComparison, SeesInTheMeansThatTrialsNeverVary) {
    for (const bool swapped : {false, true}) {
        const auto comparison = swapped ? compare_runs(made("same_seed", 1), made("random", 2))
                                        : compare_runs(made("random", 1), made("same_seed", 2));
        EXPECT_EQ(comparison.count(Likeness::different), 1u);
        EXPECT_LT(comparison.cells.front().mean->adjusted_p, 1e-6);
        EXPECT_FALSE(comparison.cells.front().spread);
    }
}

TEST(RunComparison, SaysWhyPairsAreNotTested) {
    const auto few = compare_runs(made("random", 1, 4), made("random", 2, 4));
    EXPECT_EQ(few.count(Likeness::untestable), 1u);
    EXPECT_THAT(few.cells.front().obstacles, testing::ElementsAre(Untested::few_trials));
    const auto constant = compare_runs(made("same_seed", 1), made("same_seed", 2)).cells.front();
    EXPECT_THAT(constant.obstacles, testing::ElementsAre(Untested::no_spread));
}

TEST(RunComparison, IsInconclusiveWhereItCouldDetectNothing) {
    const auto few = compare_runs(made("random", 1, 5), made("random", 2, 5));
    const CellComparison& cell = few.cells.front();
    EXPECT_LT(cell.untestable, cell.pairs);
    EXPECT_EQ(cell.ratio.pairs, 0u);
    EXPECT_EQ(few.count(Likeness::untestable), 1u);
    const auto enough = compare_runs(made("random", 1, 60), made("random", 2, 60));
    EXPECT_GT(enough.cells.front().ratio.pairs, 0u);
    EXPECT_EQ(enough.count(Likeness::alike), 1u);
}

TEST(RunComparison, ComparesTheSameRandomNumbersToTheBit) {
    const auto equal = compare_runs(made("random", 1, 60), made("random", 1, 40));
    EXPECT_EQ(equal.cells.front().basis, Basis::same_random_numbers);
    EXPECT_EQ(equal.cells.front().likeness, Likeness::alike);
    EXPECT_EQ(equal.cells.front().trials, 40u);
    EXPECT_EQ(equal.tests, 0u);

    const auto plan = made("random", 1, 10).plan();
    const auto value = [](double wrong) {
        return [wrong](std::size_t, std::uint64_t trial, int, int) { return trial == 3 ? wrong : 0.2; };
    };
    const auto changed = compare_runs(test::fill(plan, value(0.2)), test::fill(plan, value(0.25)));
    EXPECT_EQ(changed.cells.front().differing, 1u);
    EXPECT_EQ(changed.cells.front().likeness, Likeness::different);
}

TEST(RunComparison, ComparesDeterministicMethodsByValue) {
    const auto store = [](int nodes) { return made("random", 1, 10, fmt::format(fmt::runtime(quadrature), nodes)); };
    EXPECT_EQ(compare_runs(store(3), store(3)).cells[1].likeness, Likeness::alike);
    const auto comparison = compare_runs(store(3), store(4));
    EXPECT_EQ(comparison.cells.size(), 1u);  // the samples of a pair of patches follow from the nodes
    EXPECT_THAT(comparison.only_first, testing::ElementsAre(1u));
    EXPECT_THAT(comparison.only_second, testing::ElementsAre(1u));
}

TEST(RunComparison, TestsNothingWithoutVariance) {
    const auto store = [](int seed) {
        return test::run(test::plan_of(fmt::format(
            "[study]\nname = \"s\"\nscene = \"cube\"\nseed = {}\ntrials = 10\n[[method]]\nname = \"kernel\"\nsampler = "
            "\"random\"\nestimator = \"area_kernel\"\nsamples_per_patch = 64\n",
            seed)));
    };
    const auto comparison = compare_runs(store(1), store(2));
    const CellComparison& cell = comparison.cells.front();
    EXPECT_EQ(cell.untestable, 24u);  // of 30, the adjacent ones
    EXPECT_THAT(cell.obstacles, testing::ElementsAre(Untested::infinite_variance));
    for (const RmseRatio& ratio : cell.ratios)
        EXPECT_EQ(ratio.logarithms.size(), ratio.pair_class == PairClass::parallel ? 2u : 0u);
}

constexpr const char* better = R"([[method]]
name = "better"
sampler = "sobol"
estimator = "ray_shooting"
samples_per_patch = [64, 256]
)";

TEST(RunComparison, ComparesTwoMethodsOfOneRun) {
    const Store store = made("random", 1, 60, better);
    const auto comparison = compare_runs(store, store, {"rays", "better"}, MethodNames{"rays", "better"});
    ASSERT_EQ(comparison.cells.size(), 1u);  // 256 rays; 64 are of one only
    EXPECT_EQ(comparison.cells.front().basis, Basis::independent);
    EXPECT_THAT(comparison.only_first, testing::IsEmpty());
    EXPECT_EQ(comparison.only_second.size(), 1u);
    const Lead lead = comparison.lead();
    EXPECT_EQ(lead.first, 0u);
    EXPECT_GT(lead.second, 0u);
    for (const RmseRatio& ratio : comparison.cells.front().ratios) EXPECT_LT(ratio.interval->high, 1);
}

TEST(RunComparison, ListsAvailableMethods) {
    const Store store = made("random", 1, 5, better);
    const std::string message = test::message_of<UserError>([&] {
        static_cast<void>(compare_runs(store, store, {"A", "B"}, MethodNames{"rays", "bettre"}));
    });
    EXPECT_THAT(message, testing::HasSubstr("method 'bettre' (its run"));
    EXPECT_THAT(message, testing::HasSubstr("Did you mean 'better'? There are: rays, better."));
}

TEST(RunComparison, RefusesRunsWithNothingInCommon) {
    const auto box = test::run(test::plan_of(
        "[study]\nname = \"s\"\nscene = \"box:2x1x1\"\nseed = 1\ntrials = 5\n[[method]]\nname = \"rays\"\nsampler = "
        "\"random\"\nestimator = \"ray_shooting\"\nsamples_per_patch = 256\n"));
    const std::string message =
        test::message_of<UserError>([&] { static_cast<void>(compare_runs(made("random", 1, 5), box)); });
    EXPECT_THAT(message, testing::HasSubstr("the first has 'rays' on 'cube'; the second has 'rays' on 'box:2x1x1'"));
}

TEST(DifferencesOf, NamesEveryKeyThatDiffers) {
    const auto first = made("random", 1, 10).plan().spec;
    auto second = made("halton", 2, 10).plan().spec;
    second.equivalence_margin = 0.1;
    std::vector<std::string> seen;
    for (const SpecDifference& each : differences_of(first, second))
        seen.push_back(fmt::format("{}.{}: {} / {}", each.place, each.key, each.first, each.second));
    EXPECT_THAT(seen, testing::ElementsAre("study.seed: 1 / 2", "study.equivalence_margin:  / 0.1",
                                           "rays.sampler: \"random\" / \"halton\""));
    EXPECT_THAT(differences_of(first, first), testing::IsEmpty());
}

}  // namespace
}  // namespace ff::studies
