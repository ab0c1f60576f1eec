#include "reports/words/answer.hpp"

#include "reports/markdown/markdown.hpp"
#include "reports/pictures/pictures.hpp"
#include "reports/terminal/terminal.hpp"
#include "reports/text/labels.hpp"
#include "reports/words/findings/coverage_words.hpp"
#include "reports/words/headline.hpp"
#include "reports/words/in_brief.hpp"
#include "tests/support/studies.hpp"
#include "tests/unit/reports/small_study.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ff::reports {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

studies::StudyResults results_of(const std::string& keys, const std::string& methods) {
    return studies::evaluate(test::run(test::plan_of(test::study_text(keys, methods))));
}

TEST(CoverageInBrief, SaysWhereTooFewTrialsTellTheCoverage) {
    const auto lines_of = [](int trials) {
        const std::string text = fmt::format(
            "[study]\nname = \"few\"\nscene = \"cube_opposite_faces\"\ntrials = {}\nseed = 1\n[[method]]\nname = "
            "\"SR\"\nsampler = \"random\"\nestimator = \"ray_shooting\"\nsamples_per_patch = 64\n"
            "[coverage]\nreplicates = [5]\n",
            trials);
        return coverage_in_brief(studies::evaluate(test::run(test::plan_of(text))));
    };
    EXPECT_THAT(lines_of(10),
                testing::Contains("Student's t, R = 5: too few trials to tell the coverage (nominal 0.95)."));
    EXPECT_THAT(lines_of(100), testing::Each(HasSubstr("significantly short in ")));
}

TEST(ResultsInBrief, CountFirstPlacesWhereRankingsAreMany) {
    const std::string methods = R"([[method]]
name = "SR"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = [64, 256]
[[method]]
name = "SR, sobol"
sampler = "sobol"
estimator = "ray_shooting"
samples_per_patch = [64, 256]
)";
    const auto brief_of = [&](const std::string& scenes) {
        return results_in_brief(studies::evaluate(test::run(
            test::plan_of("[study]\nname = \"many\"\nscene = " + scenes + "\ntrials = 40\nseed = 1\n" + methods))));
    };
    EXPECT_THAT(brief_of("[\"cube\", \"box:1x1x2\"]"),
                testing::Contains("Least variance, alone or with others, in 8 comparisons with random points: “SR, "
                                  "sobol” in 8."));
    EXPECT_THAT(brief_of("\"cube\""), testing::Contains(HasSubstr(" “SR, sobol” has the least variance, ")));
}

TEST(Listed, NamesAFewAndCountsTheRest) {
    EXPECT_EQ(listed({}), "");
    EXPECT_EQ(listed({"a"}), "a");
    EXPECT_EQ(listed({"a", "b", "c"}), "a, b and c");
    EXPECT_EQ(listed({"a", "b", "c", "d", "e"}), "a, b, c and 2 more");
}

TEST(Answer, RecommendsMethodsAmongTheBestOnAllPairsOfAllScenes) {
    const Answer said = answer(test::small_results());
    EXPECT_EQ(said.finding.subject, Subject::errors);
    EXPECT_EQ(said.question, "Which method has the smallest error?");
    EXPECT_THAT(said.text, StartsWith("Take PDM: on pairs of all scenes nothing is shown to err less (RMSE "));
    EXPECT_THAT(said.text, HasSubstr("Infinite variances are not compared."));
    EXPECT_THAT(said.finding.details, testing::Contains(HasSubstr("n adjacent pairs of cube")));
}

// A hemicube of 3072 pixels errs less than 64 rays, but as many rays err less than the hemicube.
TEST(Answer, RecommendsNothingThatOnlyLeadsByItsCost) {
    const Answer said = answer(results_of("trials = 64", R"([[method]]
name = "a"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = 64
[[method]]
name = "b"
estimator = "hemicube"
resolution = 32
)"));
    EXPECT_EQ(said.text.find("Take "), std::string::npos) << said.text;
    EXPECT_THAT(said.text, HasSubstr("at equal evaluations a errs less"));
    EXPECT_THAT(said.finding.details, testing::Contains(HasSubstr("; at equal evaluations a errs less")));
}

TEST(Answer, SaysWhichErrorsAreNotCompared) {
    const auto text_with = [](std::string_view keys_of_the_third) {
        std::string methods;
        for (const auto& [name, keys] : {std::pair<std::string_view, std::string_view>{"a", "samples_per_patch = 64"},
                                         {"b", "samples_per_patch = 64"},
                                         {"c", keys_of_the_third}})
            methods += fmt::format(
                "[[method]]\nname = \"{}\"\nsampler = \"random\"\nestimator = \"ray_shooting\"\n{}\n", name, keys);
        return answer(results_of("trials = 64", methods)).text;
    };
    EXPECT_THAT(text_with("samples_per_patch = 64"), Not(HasSubstr("not compared")));
    EXPECT_THAT(text_with("samples_per_patch = 64\ntrials = 3"),
                HasSubstr("Methods with too few trials are not compared."));
    EXPECT_THAT(text_with("samples_per_patch = 128"), HasSubstr("Methods without a common size are not compared."));
}

TEST(Answer, LeavesThePremiseToTheDetails) {
    const Answer said = answer(test::published_results());
    EXPECT_THAT(said.text, HasSubstr("The 10 printed figures contain 2 contradictions."));
    ASSERT_FALSE(said.finding.details.empty());
    EXPECT_THAT(said.finding.details.front(),
                testing::AllOf(StartsWith("PDM as described does not give the figures printed for it"),
                               HasSubstr("times by the printed ones")));
    EXPECT_THAT(markdown_report(test::published_results()), HasSubstr(said.finding.details.front()));
}

TEST(Answer, HasAtMost35Words) {
    for (const auto& results : {test::small_results(), test::published_results()}) {
        const std::string text = answer(results).text;
        EXPECT_LE(std::count(text.begin(), text.end(), ' ') + 1, 35) << text;
    }
}

TEST(Answer, RanksSlopesThatCanBeDistinguished) {
    const auto results = results_of("trials = 100", R"([[method]]
name = "random"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = [64, 256, 1024]
[[method]]
name = "sobol"
sampler = "sobol"
estimator = "ray_shooting"
samples_per_patch = [64, 256, 1024]
)");
    EXPECT_EQ(answer(results).finding.subject, Subject::rates);
    const KeyNumber first = headline(results).numbers.front();  // about the same subject
    EXPECT_EQ(first.value, "sobol");
    EXPECT_EQ(first.label, "on parallel pairs");
    EXPECT_THAT(first.detail, StartsWith("On parallel pairs sobol converges fastest"));
    EXPECT_THAT(answer(results).text,
                testing::MatchesRegex("On parallel pairs sobol converges fastest .slope -0[^;]*; on "
                                      "adjacent pairs sobol converges fastest .slope -0.*"));
    EXPECT_THAT(markdown_report(results), HasSubstr("; random slowest (-0."));
    const auto picture = lead_picture(results);
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->kind, "ranking");
    EXPECT_THAT(picture->values, HasSubstr("adjacent pairs|sobol"));
}

// Latin hypercube rays converge as random ones do: neither is slowest.
TEST(Answer, NamesNoSlowestMethodAmongIndistinguishableOnes) {
    std::string methods;
    for (const char* sampler : {"random", "latin_hypercube", "sobol"}) {
        methods += fmt::format(
            "[[method]]\nname = \"{0}\"\nsampler = \"{0}\"\nestimator = \"ray_shooting\"\n"
            "samples_per_patch = [64, 256, 1024]\n",
            sampler);
    }
    const auto results = results_of("trials = 40", methods);
    const std::string text = answer(results).text + terminal_summary(results) + markdown_report(results);
    EXPECT_THAT(text, HasSubstr("sobol converges fastest"));
    EXPECT_THAT(text, Not(HasSubstr("slowest (")));
}

TEST(Answer, MakesNoComparisonForASingleMethod) {
    const auto results = results_of("trials = 40", R"([[method]]
name = "random"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = 64
)");
    EXPECT_THAT(answer(results).text, StartsWith("On parallel pairs random has an RMSE of "));
    EXPECT_THAT(answer(results).text, Not(HasSubstr("smallest")));
}

TEST(Answer, ComesFirstInMarkdown) {
    const std::string text = markdown_report(test::small_results());
    EXPECT_LT(text.find("*Which method has the smallest error?*"), text.find("## In brief"));
}

/// The results of a study whose publication has these claims and no figures.
studies::StudyResults with_claims(std::vector<studies::JudgedClaim> claims) {
    studies::StudyResults results = test::published_results();
    results.published->tables.figures.clear();
    results.published->audit = {};
    results.published->comparisons.clear();
    results.published->claims = std::move(claims);
    return results;
}

TEST(Answer, BeginsWithTheVerdictOnClaimsWithoutFigures) {
    studies::JudgedClaim holds{.claim = {}, .verdict = studies::ClaimVerdict::supported, .evidence = "3 of 3 hold."};
    const auto one = with_claims({holds});
    EXPECT_THAT(answer(one).text, StartsWith("The publication's claim is supported. On parallel pairs PDM errs "));
    EXPECT_THAT(answer(one).text, Not(HasSubstr("contradiction")));
    for (const KeyNumber& number : headline(one).numbers) EXPECT_NE(number.label, "contradictions in print");
    studies::JudgedClaim fails = holds;
    fails.verdict = studies::ClaimVerdict::refuted;
    EXPECT_THAT(answer(with_claims({holds, fails})).text,
                StartsWith("Of the publication's 2 claims 1 is supported, 1 refuted. "));
}

TEST(Answer, MergesEqualStatementsAboutSeveralClasses) {
    const auto results = results_of("trials = 30", R"([[method]]
name = "contour"
estimator = "contour"
sampler = "gauss_legendre"
nodes = 16
)");
    EXPECT_THAT(answer(results).text, StartsWith("On parallel and adjacent pairs contour is exact."));
}

TEST(InBrief, DoesNotRepeatClauses) {
    const auto results = results_of("trials = 30", R"([[method]]
name = "contour"
estimator = "contour"
sampler = "gauss_legendre"
nodes = 16
[[method]]
name = "control variate"
estimator = "control_variate"
sampler = "random"
samples_per_patch = 64
)");
    const std::string text = markdown_report(results);
    EXPECT_THAT(text, HasSubstr("control variate are exact to rounding"));
    EXPECT_THAT(text, Not(HasSubstr("****")));
}

TEST(Headline, CountsContradictionsAsItListsThem) {
    const Headline top = headline(test::published_results());
    EXPECT_EQ(top.published.size(), test::published_results().published->audit.contradictions());
    EXPECT_EQ(top.numbers.back().value, std::to_string(top.published.size()));
}

}  // namespace
}  // namespace ff::reports
