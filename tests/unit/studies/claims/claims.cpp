#include "studies/claims/claims.hpp"

#include "core/exact/exact.hpp"
#include "core/visibility/pair_class.hpp"
#include "stats/means/mean_test.hpp"
#include "studies/claims/claim_evidence.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <random>

namespace ff::studies {
namespace {

using test::plan_of;
using test::study_text;

/// Sampled methods A (two sizes) and B, and a deterministic D: cells 0, 1, 2 and 3.
constexpr std::string_view claim_methods = R"([[method]]
name = "A"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = [1000000, 2000000]

[[method]]
name = "B"
sampler = "random_mt"
estimator = "ray_shooting"
samples_per_patch = 1000000

[[method]]
name = "D"
sampler = "gauss_legendre"
estimator = "area_kernel"
nodes = 2
)";

/// Relative errors of one cell: standard deviations on parallel and adjacent pairs; the value itself where
/// deterministic.
struct Errors {
    double parallel = 0;
    double adjacent = 0;
};

Store trials(const std::array<Errors, 4>& errors) {
    const StudyPlan plan = plan_of(study_text("trials = 60", claim_methods));
    const Scene& scene = plan.scenes.front();
    const auto exact = exact_form_factors(scene).value();
    std::mt19937_64 bits(1);
    std::normal_distribution<double> normal;
    return test::fill(plan, [&](std::size_t cell, std::uint64_t, int from, int to) {
        const bool parallel = pair_class(scene, from - 1, to - 1) == PairClass::parallel;
        const double error = parallel ? errors[cell].parallel : errors[cell].adjacent;
        return exact(from - 1, to - 1) * (1 + error * (cell == 3 ? 1.0 : normal(bits)));
    });
}

PublishedClaim claim(std::string_view kind, std::vector<std::string> names, std::string_view pair_class = "all") {
    PublishedClaim made;
    made.id = "c";
    made.kind = kind;
    made.methods = std::move(names);
    made.pair_class = pair_class;
    return made;
}

PublishedTables about_the_cube() {
    PublishedTables tables;
    tables.scene.name = "cube";
    return tables;
}

JudgedClaim judged(const Store& store, const PublishedClaim& claim, PublishedTables tables = about_the_cube()) {
    tables.claims = {claim};
    const auto list = judge_claims(store, analyse(store), tables);
    EXPECT_EQ(list.size(), 1u);
    EXPECT_FALSE(list.at(0).evidence.empty());
    return list.at(0);
}

ClaimVerdict verdict(const std::array<Errors, 4>& errors, const PublishedClaim& claim) {
    return judged(trials(errors), claim).verdict;
}

constexpr Errors small{1e-4, 1e-4};
constexpr Errors large{1e-3, 1e-3};

TEST(ErrorFalls, IsSupportedRefutedOrInconclusive) {
    const auto falls = claim("error_falls_with_samples", {"A"});
    EXPECT_EQ(verdict({large, small, small, small}, falls), ClaimVerdict::supported);
    EXPECT_EQ(verdict({small, large, small, small}, falls), ClaimVerdict::refuted);
    EXPECT_EQ(verdict({large, large, small, small}, falls), ClaimVerdict::inconclusive);
}

TEST(ErrorDoesNotAlwaysFall, IsJudgedFromSingleRuns) {
    const auto not_always = claim("error_falls_with_subdivision_not_always", {"A"});
    EXPECT_EQ(verdict({large, large, small, small}, not_always), ClaimVerdict::supported);
    EXPECT_EQ(verdict({Errors{1e-2, 1e-2}, Errors{1e-6, 1e-6}, small, small}, not_always), ClaimVerdict::inconclusive)
        << "none of 60 runs: up to 6 % are possible";
}

TEST(SmallerError, ComparesOneClassOfPairs) {
    const auto parallel = claim("smaller_error", {"A", "B"}, "parallel");
    const auto adjacent = claim("smaller_error", {"A", "B"}, "adjacent");
    const std::array<Errors, 4> errors{Errors{1e-4, 1e-3}, small, Errors{1e-3, 1e-4}, small};
    EXPECT_EQ(verdict(errors, parallel), ClaimVerdict::supported);
    EXPECT_EQ(verdict(errors, adjacent), ClaimVerdict::refuted);
    EXPECT_EQ(verdict({large, large, large, large}, parallel), ClaimVerdict::inconclusive);
}

TEST(Claims, AreInconclusiveAboutMeansOfInfiniteVariance) {
    const Store store = trials({small, small, large, small});
    Analysis findings = analyse(store);
    PublishedTables tables = about_the_cube();
    tables.claims = {claim("smaller_error", {"A", "B"}, "adjacent"), claim("smaller_error", {"A", "B"}, "parallel"),
                     claim("error_falls_with_subdivision_not_always", {"A"})};
    for (Summary& summary : findings.cells[2].summaries) {
        if (summary.pair_class == PairClass::adjacent) summary.variance = VarianceStatus::infinite;
    }
    const auto judged = judge_claims(store, findings, tables);
    EXPECT_EQ(judged.at(0).verdict, ClaimVerdict::inconclusive);
    EXPECT_THAT(judged.at(0).evidence, testing::HasSubstr("infinite variance"));
    EXPECT_EQ(judged.at(1).verdict, ClaimVerdict::supported);
    EXPECT_EQ(judged.at(2).verdict, ClaimVerdict::supported) << "shares of runs need no variance";
}

TEST(SmallerError, ComparesADeterministicMethodWithTheMean) {
    const auto beats = claim("smaller_error", {"D", "A"}, "parallel");
    EXPECT_EQ(verdict({large, small, small, small}, beats), ClaimVerdict::supported);
    EXPECT_EQ(verdict({small, small, small, large}, beats), ClaimVerdict::refuted);
}

TEST(SmallerSumError, IsAboutRowSums) {
    const auto sums = claim("smaller_sum_error", {"A", "B"});
    EXPECT_EQ(verdict({small, small, large, small}, sums), ClaimVerdict::supported);
    EXPECT_EQ(verdict({large, small, small, small}, sums), ClaimVerdict::refuted);
    EXPECT_EQ(verdict({large, small, large, small}, sums), ClaimVerdict::inconclusive);
}

TEST(Counts, AreComparedWithSingleRuns) {
    // |normal| > 1 on about 32 % of the 12 adjacent pairs: 4 of them, 1 to 7 in most runs.
    const std::array<Errors, 4> errors{large, small, small, large};
    auto count = claim("count_larger_error", {"A", "D"}, "adjacent");
    for (const auto& [number, expected] :
         {std::pair(4.0, ClaimVerdict::supported), std::pair(0.0, ClaimVerdict::refuted),
          std::pair(12.0, ClaimVerdict::refuted)}) {
        count.number = number;
        EXPECT_EQ(verdict(errors, count), expected) << number;
    }
}

TEST(Counts, UseThePrintedErrorsOfTheOtherMethodFirst) {
    PublishedTables tables = about_the_cube();
    const auto add = [&](int from, int to) {
        Figure figure;
        figure.method = "D";
        figure.kind = FigureKind::relative_error;
        figure.from = std::to_string(from);
        figure.to = std::to_string(to);
        figure.printed = "0.0";  // percent: every run errs more on every pair
        tables.figures.push_back(figure);
    };
    for (const auto& [from, to] : {std::pair(1, 6), std::pair(2, 3), std::pair(4, 5)}) add(from, to);
    auto count = claim("count_larger_error", {"A", "D"}, "parallel");
    count.number = 3;
    count.patches_per_face = {1};
    const JudgedClaim found = judged(trials({small, small, small, large}), count, tables);
    EXPECT_EQ(found.verdict, ClaimVerdict::as_printed_only);
    EXPECT_THAT(found.evidence, testing::HasSubstr("Against the printed D errors"));
    EXPECT_THAT(found.evidence, testing::HasSubstr("D as computed here"));
    for (Figure& figure : tables.figures) figure.patches_per_face = 4;  // not what the claim is about
    EXPECT_THAT(judged(trials({small, small, small, large}), count, tables).evidence,
                testing::Not(testing::HasSubstr("printed")));
}

TEST(NotAlwaysSmaller, NeedsAPairWithALargerError) {
    const auto not_always = claim("smaller_error_not_always", {"A", "D"}, "adjacent");
    EXPECT_EQ(verdict({large, small, small, large}, not_always), ClaimVerdict::supported);
    EXPECT_NE(verdict({Errors{1e-6, 1e-6}, small, small, large}, not_always), ClaimVerdict::supported);
}

TEST(UniformError, HoldsWithinEachClassOfPairs) {
    const auto uniform = claim("uniform_error", {"D"});
    EXPECT_EQ(verdict({small, small, small, Errors{1e-4, 1e-2}}, uniform), ClaimVerdict::supported);
    EXPECT_EQ(verdict({small, small, small, large}, claim("uniform_error", {"A"})), ClaimVerdict::refuted);
}

TEST(NonuniformError, HoldsForIndependentErrorsOnly) {
    EXPECT_EQ(verdict({large, small, small, small}, claim("nonuniform_error", {"A"})), ClaimVerdict::supported);
    EXPECT_EQ(verdict({small, small, small, large}, claim("nonuniform_error", {"D"})), ClaimVerdict::refuted);
}

TEST(Division, RequiresEachMethodToBeBestOnItsClass) {
    for (const char* kind : {"no_single_best", "best_per_class"}) {
        const auto division = claim(kind, {"A", "B"});
        EXPECT_EQ(verdict({Errors{1e-4, 1e-3}, small, Errors{1e-3, 1e-4}, small}, division), ClaimVerdict::supported);
        EXPECT_EQ(verdict({small, small, large, small}, division), ClaimVerdict::refuted);
        EXPECT_EQ(verdict({Errors{1e-4, 1e-3}, small, large, small}, division), ClaimVerdict::inconclusive);
    }
}

TEST(Division, DeclaresNoWinnerAmongRoundingErrors) {
    const auto division = claim("best_per_class", {"D", "A"});
    const auto found = judged(trials({large, small, large, Errors{1e-15, 1e-2}}), division);
    EXPECT_EQ(found.verdict, ClaimVerdict::supported);
    EXPECT_THAT(found.evidence, testing::HasSubstr("D exact to rounding, A "));
    EXPECT_THAT(found.evidence, testing::HasSubstr("best on parallel pairs: D (exact to rounding)"));
}

TEST(Advice, IsJudgedBetweenTwoMethodsAndAmongAllMethods) {
    const auto advice = claim("best_per_class", {"D", "A"});
    const auto evidence = [&](const Errors& a, const Errors& b, const Errors& d) {
        return judged(trials({a, a, b, d}), advice).evidence;
    };
    const auto says = [](const char* between, const char* rule) {
        return testing::AllOf(
            testing::StartsWith(fmt::format("Between these two methods the advice (D for parallel faces, A for "
                                            "perpendicular ones) was {}, with 95 % confidence. As a rule",
                                            between)),
            testing::HasSubstr(fmt::format("it was {} among the methods of this study", rule)));
    };
    const Errors exact_on_parallel{1e-15, 1e-3};
    EXPECT_THAT(evidence({1e-4, 1e-4}, {1e-2, 1e-2}, exact_on_parallel), says("right", "right"));
    EXPECT_THAT(evidence({1e-4, 1e-2}, {1e-2, 1e-4}, exact_on_parallel), says("wrong", "right"));
    EXPECT_THAT(evidence({1e-2, 1e-4}, {1e-4, 1e-2}, {1e-3, 1e-3}), says("right", "wrong"));
    EXPECT_THAT(evidence({1e-2, 1.25e-3}, {1e-2, 1e-2}, {1e-3, 1e-3}),
                says("neither shown to be right nor to be wrong", "neither shown to be right nor to be wrong"));
    EXPECT_THAT(evidence({1e-4, 1e-4}, {1e-2, 1e-2}, exact_on_parallel),
                testing::AllOf(testing::HasSubstr("on parallel pairs D (exact to rounding) against A (0.00"),
                               testing::HasSubstr("%); on perpendicular ones A (0.00"), testing::HasSubstr(" ± 0.00"),
                               testing::HasSubstr(" %) against D (0.1 %). ")));
}

TEST(Advice, NamesAllThatMayBeTheBest) {
    const Errors alike{1e-3, 1e-3};
    const std::string evidence =
        judged(trials({alike, alike, alike, Errors{1e-2, 1e-4}}), claim("best_per_class", {"D", "A"})).evidence;
    EXPECT_THAT(evidence, testing::HasSubstr("best on parallel pairs: A or B ("));
    EXPECT_THAT(evidence, testing::HasSubstr("; on adjacent ones: D (0.01 %)"));
    EXPECT_THAT(evidence, testing::HasSubstr("on perpendicular ones A or B ("));
}

TEST(Advice, AllowsForSelectionOfTheBestMethod) {
    // Where A's own interval just excludes the error of D, that of the best of four methods does not.
    const auto closer = claim("smaller_error", {"A", "D"}, "adjacent");
    const auto advice = claim("best_per_class", {"D", "A"});
    int only_by_itself = 0;
    for (double error = 0.8e-3; error < 0.9e-3; error += 0.5e-5) {
        const auto store = trials({large, Errors{1e-2, 1e-2}, Errors{1e-2, 1e-2}, Errors{1e-15, error}});
        const bool right = judged(store, advice).evidence.find("it was right among") != std::string::npos;
        const bool by_itself = judged(store, closer).verdict == ClaimVerdict::supported;
        EXPECT_TRUE(by_itself || !right) << error;
        if (by_itself && !right) ++only_by_itself;
    }
    EXPECT_GE(only_by_itself, 1);
    EXPECT_LE(only_by_itself, 5);
}

TEST(Claims, AreInconclusiveAboutWhatTheStudyLacks) {
    PublishedTables tables = about_the_cube();
    for (const char* kind :
         {"error_falls_with_subdivision", "error_falls_with_subdivision_not_always", "error_falls_with_samples",
          "smaller_sum_error", "smaller_error", "smaller_error_not_always", "count_larger_error", "uniform_error",
          "nonuniform_error", "no_single_best", "best_per_class", "unheard_of"}) {
        const bool about_one = std::string_view(kind).find("uniform") != std::string_view::npos;
        for (const auto& names : {std::vector<std::string>{"X", "Y"}, {about_one ? "X" : "A", "Y"}, {"X"}, {}}) {
            auto unknown = claim(kind, names, "parallel");
            unknown.samples_per_patch = {1'000'000};
            unknown.number = 2;
            tables.claims.push_back(unknown);
        }
    }
    const Store store = trials({small, small, small, small});
    const auto list = judge_claims(store, analyse(store), tables);
    ASSERT_EQ(list.size(), tables.claims.size());
    for (const JudgedClaim& judged : list) {
        EXPECT_EQ(judged.verdict, ClaimVerdict::inconclusive) << judged.claim.kind;
        EXPECT_FALSE(judged.evidence.empty());
    }
}

TEST(Claims, AreInconclusiveAboutAnotherScene) {
    const auto falls = claim("error_falls_with_samples", {"A"});
    PublishedTables elsewhere;
    elsewhere.scene.name = "box:1x2x3";
    EXPECT_EQ(judged(trials({large, small, small, small}), falls).verdict, ClaimVerdict::supported);
    EXPECT_EQ(judged(trials({large, small, small, small}), falls, elsewhere).verdict, ClaimVerdict::inconclusive);
}

TEST(Claims, NeedBothMethodsThatTheyCompare) {
    PublishedTables tables = about_the_cube();
    Figure figure;
    figure.kind = FigureKind::relative_error;
    figure.method = "D";
    tables.figures = {figure};
    for (const char* kind : {"count_larger_error", "smaller_error_not_always"}) {
        auto lonely = claim(kind, {"A"}, "parallel");
        lonely.number = 2;
        EXPECT_EQ(judged(trials({small, small, small, small}), lonely, tables).verdict, ClaimVerdict::inconclusive);
    }
}

TEST(ClaimEvidence, OrdersTheCellsOfTheClaimBySize) {
    const Store store = trials({small, small, small, small});
    const Analysis findings = analyse(store);
    const PublishedTables tables = about_the_cube();
    const ClaimEvidence evidence(store, findings, tables, 0);
    auto sizes = claim("smaller_error", {"A", "D"});
    EXPECT_THAT(evidence.cells(sizes, 0), testing::ElementsAre(0, 1));
    EXPECT_THAT(evidence.cells(sizes, 1), testing::ElementsAre(3));
    sizes.samples_per_patch = {2'000'000};
    EXPECT_THAT(evidence.cells(sizes, 0), testing::ElementsAre(1));
    EXPECT_THAT(evidence.cells(sizes, 1), testing::ElementsAre(3)) << "a deterministic method has no samples";
    sizes.patches_per_face = {4};
    EXPECT_TRUE(evidence.cells(sizes, 0).empty());
    EXPECT_EQ(evidence.pairs("parallel").size(), 3u);
    EXPECT_EQ(evidence.pairs("adjacent").size(), 12u);
    EXPECT_EQ(evidence.pairs("all").size(), 15u);
}

TEST(MeanWithError, HasTheLongerSideOfTheInterval) {
    std::vector<double> values;
    for (int i = 0; i < 40; ++i) values.push_back(std::exp(i / 20.0));
    const MeanWithError mean = mean_with_error(values, 0.95);
    const auto interval = *stats::mean_interval(values, mean.mean, 0.95);
    EXPECT_GT(interval.high, -interval.low);
    EXPECT_EQ(mean.half_width, interval.high);
    EXPECT_EQ(mean_with_error({5}, 0.95).half_width, 0.0);
}

TEST(MeanWithError, IsUnboundedForTooFewTrials) {
    EXPECT_TRUE(std::isinf(mean_with_error({1, 2, 4}, 0.95).half_width));
}

}  // namespace
}  // namespace ff::studies
