#include "studies/analysis/analysis.hpp"

#include "core/exact/exact.hpp"
#include "stats/error_rates/multiplicity.hpp"
#include "stats/error_rates/power.hpp"
#include "tests/support/repetitions.hpp"
#include "tests/support/statistical_assertions.hpp"
#include "tests/support/studies.hpp"
#include "tests/unit/studies/quantities.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace ff::studies {
namespace {

using test::pair;
using test::plan_of;
using test::study_text;

constexpr double trial_sigma = 1e-3;  ///< of made-up trials

/// Rays in such numbers that a hit is a thousandth of sigma: made-up trials are as good as real numbers. The sampler is
/// one whose hits are not taken for binomial, as those trials are not.
std::string many_rays(std::string_view completion = "direct") {
    return fmt::format(
        "[[method]]\nname = \"SR\"\nsampler = \"antithetic_directions\"\nestimator = \"ray_shooting\"\n"
        "samples_per_patch = 1000000\ncompletion = \"{}\"\n",
        completion);
}

constexpr std::string_view few_rays =
    "[[method]]\nname = \"SR\"\nsampler = \"random\"\nestimator = \"ray_shooting\"\nsamples_per_patch = 1000\n";

/// Trials that are normal around the exact factor; those of F 1-2 around a shifted one.
Store normal_trials(const StudyPlan& plan, std::uint64_t seed, double shift) {
    const auto exact = exact_form_factors(plan.scenes.front()).value();
    std::mt19937_64 bits(seed);
    std::normal_distribution<double> normal(0, trial_sigma);
    return test::fill(plan, [&](std::size_t, std::uint64_t, int from, int to) {
        return exact(from - 1, to - 1) + normal(bits) + (from == 1 && to == 2 ? shift : 0.0);
    });
}

TEST(Bias, IsFoundOnASinglePairAboveTheMinimumDetectable) {
    const StudyPlan plan = plan_of(study_text("trials = 40", many_rays()));
    const Analysis clean = analyse(normal_trials(plan, 1, 0));
    ASSERT_TRUE(clean.complete);
    const CellAnalysis& cell = clean.cells.at(0);
    EXPECT_EQ(cell.bias_finding, BiasFinding::no_bias_found);
    EXPECT_EQ(cell.bias->pairs, 30u);
    EXPECT_EQ(cell.bias->untestable, 0u);

    const Analysis shifted = analyse(normal_trials(plan, 1, 2 * cell.bias->minimum_detectable_bias.value()));
    EXPECT_EQ(shifted.cells.at(0).bias_finding, BiasFinding::biased);
    EXPECT_EQ(shifted.cells.at(0).bias->largest_pair, (Quantity{pair, 1, 2}));
    EXPECT_LT(shifted.cells.at(0).bias->adjusted_p, 0.05);
}

/// How often a study with this bias on one of 30 pairs of both of its cells is called biased.
std::uint64_t biased_studies(std::uint64_t studies, double shift) {
    const StudyPlan plan = plan_of(study_text("trials = 16", many_rays()));
    std::uint64_t biased = 0;
    for (std::uint64_t seed = 0; seed < studies; ++seed) {
        const Store store = normal_trials(plan, seed, shift);
        if (analyse_cell(store, 0).bias_finding == BiasFinding::biased) ++biased;
    }
    return biased;
}

TEST(Bias, IsClaimedOfUnbiasedMethodsAtTheStatedRate) {
    // Nominal: Bonferroni over 30 independent pairs, 1 - (1 - .05 / 30)^30 = 0.0488.
    constexpr std::uint64_t studies = 400;
    EXPECT_TRUE(test::has_probability(biased_studies(studies, 0), studies, 0.0488,
                                      {.alpha = 1e-4, .detects = 0.08, .power = 0.95}));
}

TEST(Bias, IsFoundAtTheMinimumDetectableSizeWithTheStatedPower) {
    // The other 29 pairs find something at times as well, so at least.
    const std::uint64_t studies = test::repetitions(80, 200);
    const double alpha = stats::sidak_level(0.05, 30);
    const double detectable = stats::minimum_detectable_bias(trial_sigma, 16, {alpha, 0.9});
    EXPECT_TRUE(
        test::has_probability_at_least(biased_studies(studies, detectable), studies, 0.9,
                                       {.alpha = 1e-4, .detects = test::is_nightly() ? 0.15 : 0.25, .power = 0.95}));
}

TEST(Bias, IsJudgedAtTheErrorRateOfTheWholeStudy) {
    const StudyPlan one = plan_of(study_text("trials = 16", many_rays()));
    std::string methods = many_rays();
    for (int i = 0; i < 4; ++i) {
        methods += fmt::format(
            "[[method]]\nname = \"{}\"\nsampler = \"antithetic_directions\"\nestimator = \"ray_shooting\"\n"
            "samples_per_patch = {}\n",
            i, 1'000'002 + 2 * i);
    }
    const StudyPlan five = plan_of(study_text("trials = 16", methods));
    const double shift = 3e-3;
    const auto alone = analyse_cell(normal_trials(one, 5, shift), 0);
    const auto among = analyse_cell(normal_trials(five, 5, shift), 0);
    EXPECT_NEAR(among.bias->adjusted_p, 1 - std::pow(1 - alone.bias->adjusted_p, 5), 1e-12);
    EXPECT_GT(among.bias->minimum_detectable_bias, alone.bias->minimum_detectable_bias);
}

TEST(Bias, CountsFifteenPairsUnderReciprocity) {
    const StudyPlan plan = plan_of(study_text("trials = 16", many_rays("reciprocal")));
    EXPECT_EQ(analyse_cell(normal_trials(plan, 1, 0), 0).bias->pairs, 15u);
}

TEST(Equivalence, IsShownRefutedOrLeftOpen) {
    const auto finding = [](double margin, double shift) {
        const StudyPlan plan =
            plan_of(study_text(fmt::format("trials = 40\nequivalence_margin = {}", margin), many_rays()));
        return analyse_cell(normal_trials(plan, 3, shift), 0).equivalence;
    };
    EXPECT_EQ(finding(2e-3, 0), EquivalenceFinding::shown);
    EXPECT_EQ(finding(1e-4, 0), EquivalenceFinding::inconclusive);
    EXPECT_EQ(finding(2e-3, 5e-3), EquivalenceFinding::refuted);
    EXPECT_EQ(finding(2e-3, 2e-3), EquivalenceFinding::inconclusive);
}

TEST(Equivalence, IsShownAtThePlannedMarginWithTheStatedPower) {
    constexpr std::uint64_t studies = 100;
    const double margin = stats::equivalence_margin(trial_sigma, 16, {0.05, 0.9}, 30);
    const StudyPlan plan =
        plan_of(study_text(fmt::format("trials = 16\nequivalence_margin = {}", margin), many_rays()));
    std::uint64_t shown = 0;
    for (std::uint64_t seed = 0; seed < studies; ++seed) {
        if (analyse_cell(normal_trials(plan, seed, 0), 0).equivalence == EquivalenceFinding::shown) ++shown;
    }
    EXPECT_TRUE(test::has_probability_at_least(shown, studies, 0.9, {.alpha = 1e-4, .detects = 0.2, .power = 0.9}));
}

TEST(Equivalence, IsNotTestedWithoutAMargin) {
    const StudyPlan plan = plan_of(study_text("trials = 16", many_rays()));
    EXPECT_EQ(analyse_cell(normal_trials(plan, 3, 0), 0).equivalence, EquivalenceFinding::not_asked);
}

TEST(InfiniteVariance, LeavesAdjacentPairsWithoutIntervalAndTest) {
    const Store store = test::run(
        plan_of(study_text("trials = 30\nequivalence_margin = 0.1",
                           "[[method]]\nname = \"kernel\"\nsampler = \"random\"\nestimator = \"area_kernel\"\n"
                           "samples_per_patch = 100")));
    const CellAnalysis found = analyse_cell(store, 0);
    for (const Summary& s : found.summaries) {
        const bool parallel = s.pair_class == PairClass::parallel;
        EXPECT_EQ(s.variance, parallel ? VarianceStatus::finite : VarianceStatus::infinite);
        EXPECT_EQ(s.bias_interval.has_value(), parallel);
        EXPECT_EQ(s.std_interval.has_value(), parallel);
        EXPECT_TRUE(s.mean && s.median);
    }
    EXPECT_EQ(found.bias->pairs, 30u);
    EXPECT_EQ(found.bias->untestable, 24u);
    EXPECT_EQ(found.bias->infinite_variance, 24u);
    EXPECT_EQ(found.equivalence, EquivalenceFinding::inconclusive);
}

TEST(InfiniteVariance, IsRemovedByTheGradedMap) {
    const Store store = test::run(
        plan_of(study_text("trials = 100",
                           "[[method]]\nname = \"kernel\"\nsampler = \"random\"\nestimator = \"area_kernel\"\n"
                           "map = \"graded\"\nsamples_per_patch = 100")));
    const CellAnalysis found = analyse_cell(store, 0);
    for (const Summary& s : found.summaries) {
        EXPECT_EQ(s.variance, VarianceStatus::finite);
        EXPECT_EQ(s.bias_interval.has_value(), s.reference.has_value());
    }
    EXPECT_EQ(found.bias->infinite_variance, 0u);
}

TEST(Bias, IsFoundWhereAllTrialsGiveOneWrongValue) {
    // The effect of equal seeds in every trial: no spread, so no test, but not a good result either.
    const StudyPlan plan = plan_of(study_text("trials = 16", many_rays()));
    const auto exact = exact_form_factors(plan.scenes.front()).value();
    const auto found = [&](double shift) {
        return analyse_cell(test::fill(plan, [&](std::size_t, std::uint64_t, int from,
                                                 int to) { return exact(from - 1, to - 1) + shift; }),
                            0);
    };
    EXPECT_EQ(found(1e-3).bias_finding, BiasFinding::biased);
    EXPECT_TRUE(found(1e-3).bias->constant_and_wrong);
    EXPECT_EQ(found(0).bias_finding, BiasFinding::untestable);
}

TEST(Bias, IsNotFoundInHitsThatAgreeByChance) {
    // Every pair has the same hits in all trials, 2.5 of 256 away from the expected ones: at most a third of all
    // trials give these, so 3^(1 - T) a pair, over 30 pairs.
    const std::string rays =
        "[[method]]\nname = \"SR\"\nsampler = \"random\"\nestimator = \"ray_shooting\"\nsamples_per_patch = 256";
    const auto finding = [&](int trials) {
        const StudyPlan plan = plan_of(study_text(fmt::format("trials = {}", trials), rays));
        const auto exact = exact_form_factors(plan.scenes.front()).value();
        return analyse_cell(
                   test::fill(plan, [&](std::size_t, std::uint64_t, int from,
                                        int to) { return std::round(256 * exact(from - 1, to - 1) + 2.5) / 256; }),
                   0)
            .bias_finding;
    };
    for (const int trials : {2, 3, 5, 6}) EXPECT_EQ(finding(trials), BiasFinding::untestable) << trials;
    EXPECT_EQ(finding(20), BiasFinding::biased);
}

TEST(FewTrials, GiveEstimatesWithoutVerdicts) {
    for (const int trials : {2, 3, 4}) {
        const StudyPlan plan =
            plan_of(study_text(fmt::format("trials = {}\nequivalence_margin = 0.1", trials), many_rays()));
        const std::string note = fmt::format("{}", fmt::join(plan.warnings, "|"));
        EXPECT_NE(note.find("fewer than 5 trials"), std::string::npos) << note;
        const Analysis findings = analyse(normal_trials(plan, 1, 0));
        const CellAnalysis& cell = findings.cells.at(0);
        EXPECT_EQ(cell.bias_finding, BiasFinding::untestable);
        EXPECT_TRUE(cell.bias->few_trials);
        EXPECT_FALSE(cell.bias->minimum_detectable_bias);
        EXPECT_EQ(cell.equivalence, EquivalenceFinding::inconclusive);
        EXPECT_TRUE(cell.summary({pair, 1, 2}).mean);
        EXPECT_FALSE(cell.summary({pair, 1, 2}).minimum_detectable_bias);
        for (const ClassError& error : cell.class_errors) {
            EXPECT_GT(error.rmse, 0);
            EXPECT_FALSE(error.mean_square || error.squared_deviation || error.interval || error.variance_interval);
        }
    }
    const Analysis enough = analyse(normal_trials(plan_of(study_text("trials = 5", many_rays())), 1, 0));
    EXPECT_TRUE(enough.plan.warnings.empty());
    EXPECT_TRUE(enough.cells.at(0).class_errors.front().mean_square);
}

TEST(Bias, HasNoMinimumDetectableSizeWhereThatWouldExceedOne) {
    // In each of five trials another face gets all rays: what could be detected is beyond 1.
    const StudyPlan plan = plan_of(study_text("trials = 5", many_rays()));
    const Store store = test::fill(plan, [](std::size_t, std::uint64_t trial, int from, int to) {
        return to == static_cast<int>((static_cast<std::uint64_t>(from) + trial) % 6) + 1 ? 1.0 : 0.0;
    });
    const CellAnalysis cell = analyse_cell(store, 0);
    EXPECT_EQ(cell.bias_finding, BiasFinding::untestable);
    EXPECT_TRUE(cell.bias->few_trials);
    EXPECT_FALSE(cell.summary({pair, 1, 2}).minimum_detectable_bias);
}

TEST(Bias, IsTestedByCountsWhereHitsAreFew) {
    // 16 trials of 1 ray from each of 4 patches: 13 hits per pair.
    const Store store =
        test::run(plan_of(study_text("trials = 16",
                                     "[[method]]\nname = \"SR\"\nsampler = \"random\"\nestimator = \"ray_shooting\"\n"
                                     "patches_per_face = 4\nsamples_per_patch = 1")));
    const CellAnalysis found = analyse_cell(store, 0);
    EXPECT_EQ(found.bias_finding, BiasFinding::no_bias_found);
    EXPECT_EQ(found.bias->too_few_hits, 0u);
    EXPECT_EQ(found.summary({pair, 1, 2}).bias_interval->method, "clopper_pearson");
    EXPECT_EQ(found.summary({pair, 1, 2}).variance, VarianceStatus::sparse);
}

TEST(Analysis, TestsNothingForADeterministicMethod) {
    const Store store = test::run(plan_of(study_text(
        "trials = 30\nequivalence_margin = 0.1",
        "[[method]]\nname = \"PDM\"\nsampler = \"gauss_legendre\"\nestimator = \"area_kernel\"\nnodes = 2")));
    const CellAnalysis found = analyse_cell(store, 0);
    EXPECT_EQ(found.trials, 1u);
    EXPECT_FALSE(found.bias);
    EXPECT_EQ(found.equivalence, EquivalenceFinding::not_asked);
    for (const Summary& s : found.summaries) {
        EXPECT_FALSE(s.std || s.bias_interval || s.std_interval || s.minimum_detectable_bias);
        EXPECT_TRUE(s.mean);
    }
    EXPECT_GT(found.class_rmse(PairClass::adjacent), found.class_rmse(PairClass::parallel));
    EXPECT_EQ(found.class_rmse(PairClass::other), std::nullopt);
}

TEST(Analysis, ReportsALostRay) {
    const StudyPlan plan = plan_of(study_text("trials = 16", many_rays()));
    Store store = Store::create_or_resume(test::in_memory, plan);
    for (const WorkUnit& unit : plan.units) {
        UnitRecord record{unit.index, {}, {}, {}};
        for (std::uint64_t t = unit.first_trial; t < unit.first_trial + unit.trials; ++t)
            for (int from = 1; from <= 6; ++from)
                for (int to = 1; to <= 6; ++to)
                    if (from != to)
                        record.observations.push_back({observable::hits, from, to, t, std::int64_t{40'000}});
        if (unit.index == 0) record.observations.push_back({observable::lost, 1, 0, 0, std::int64_t{1}});
        store.commit(record);
    }
    EXPECT_EQ(analyse_cell(store, 0).lost_rays, 1u);
}

TEST(Analysis, ReportsThatAStudyIsUnfinished) {
    const StudyPlan plan = plan_of(study_text("trials = 16", many_rays() + "[[method]]\nname = \"e\"\nestimator = "
                                                                           "\"closed_form\"\n"));
    const Store store = Store::create_or_resume(test::in_memory, plan);
    const Analysis findings = analyse(store);
    EXPECT_FALSE(findings.complete);
    EXPECT_EQ(findings.cells.at(0).trials, 0u);
    EXPECT_EQ(findings.cells.at(0).trials_planned, 16u);
    EXPECT_THAT(findings.cells.at(0).summaries, testing::IsEmpty());
}

TEST(Analysis, MeasuresFromTheExactFactorsOfTheScene) {
    const Store store = test::run(
        plan_of("[study]\nname = \"t\"\nscene = \"box:2x1x0.5\"\ntrials = 4\nseed = 1\n" + std::string(few_rays)));
    const CellAnalysis found = analyse_cell(store, 0);
    const Scene& scene = store.plan().scenes.front();
    for (int i = 1; i <= 6; ++i) {
        EXPECT_EQ(found.summary({QuantityKind::row_sum, i, 0}).reference, 1.0);
        for (int j = 1; j <= 6; ++j) {
            if (i == j) continue;
            EXPECT_EQ(found.summary({pair, i, j}).reference, exact_form_factors(scene).value()(i - 1, j - 1));
        }
    }
    EXPECT_EQ(found.summary({QuantityKind::sum_relative_error, 0, 0}).reference, std::nullopt);
}

TEST(Analysis, UsesTheAvailableExactFactors) {
    const Store store = test::run(
        plan_of("[study]\nname = \"t\"\nscene = \"l_shaped_room\"\ntrials = 40\nseed = 1\n" + std::string(few_rays)));
    const CellAnalysis found = analyse_cell(store, 0);
    // Exact values by the formula of the catalogue, by closed form, and none past the corner.
    EXPECT_NEAR(found.summary({pair, 1, 2}).reference.value(), 0.032890247563088, 1e-14);
    EXPECT_NEAR(found.summary({pair, 1, 4}).reference.value(), 0.027473405707512, 1e-14);  // ffstudy explain
    EXPECT_FALSE(found.summary({pair, 2, 6}).reference);
    EXPECT_EQ(found.summary({QuantityKind::row_sum, 2, 0}).reference, 1.0);
    ASSERT_TRUE(found.bias);
    EXPECT_EQ(found.bias->pairs, 90u);
    EXPECT_GT(found.bias->no_exact_value, 0u);
    EXPECT_LT(found.bias->no_exact_value, found.bias->untestable);  // faces that cannot see each other have no spread
    // A false alarm has a chance of 1e-6.
    EXPECT_GT(found.bias->adjusted_p, 1e-6);
    const ClassError* parallel = found.class_error(PairClass::parallel);
    ASSERT_NE(parallel, nullptr);
    EXPECT_GT(parallel->rmse, 0);
    EXPECT_TRUE(parallel->interval);
}

TEST(Analysis, GivesTheSameBitsForTheSameStore) {
    const Store store = test::run(plan_of(study_text("trials = 30", few_rays)));
    const CellAnalysis a = analyse_cell(store, 0);
    const CellAnalysis b = analyse_cell(store, 0);
    for (std::size_t i = 0; i < a.summaries.size(); ++i) {
        EXPECT_EQ(a.summaries[i].normality_p, b.summaries[i].normality_p);
        EXPECT_EQ(a.summaries[i].bias, b.summaries[i].bias);
    }
    EXPECT_EQ(a.bias->adjusted_p, b.bias->adjusted_p);
}

}  // namespace
}  // namespace ff::studies
