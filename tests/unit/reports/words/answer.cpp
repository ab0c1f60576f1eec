#include "reports/words/answer.hpp"

#include "reports/markdown/markdown.hpp"
#include "reports/pictures/pictures.hpp"
#include "reports/words/headline.hpp"
#include "tests/support/studies.hpp"
#include "tests/unit/reports/small_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ff::reports {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

studies::StudyResults results_of(const std::string& keys, const std::string& methods) {
    return studies::evaluate(test::run(test::plan_of(test::study_text(keys, methods))));
}

TEST(Listed, NamesAFewAndCountsTheRest) {
    EXPECT_EQ(listed({}), "");
    EXPECT_EQ(listed({"a"}), "a");
    EXPECT_EQ(listed({"a", "b", "c"}), "a, b and c");
    EXPECT_EQ(listed({"a", "b", "c", "d", "e"}), "a, b, c and 2 more");
}

TEST(Answer, NamesTheSmallestErrorOfEachClassOfPairs) {
    const Answer said = answer(test::small_results());
    EXPECT_EQ(subject_of(test::small_results()), Subject::errors);
    EXPECT_EQ(said.question, "Which method has the smallest error?");
    EXPECT_THAT(said.text, HasSubstr("on adjacent pairs of cube"));
}

TEST(Answer, BeginsWithWhatAMethodAsDescribedDoesNotGive) {
    const std::string text = answer(test::published_results()).text;
    EXPECT_THAT(text, StartsWith("PDM as described does not give the figures printed for it"));
    EXPECT_THAT(text, HasSubstr("times by the printed ones"));
}

TEST(Answer, RanksSlopesThatCanBeToldApart) {
    const auto results = results_of("trials = 40", R"([[method]]
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
    EXPECT_EQ(subject_of(results), Subject::rates);
    EXPECT_THAT(answer(results).text, HasSubstr("sobol converges fastest (slope -0."));
    EXPECT_THAT(answer(results).text, HasSubstr("random slowest (-0."));
    const auto picture = lead_picture(results);
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->kind, "ranking");
    EXPECT_THAT(picture->values, HasSubstr("adjacent pairs|sobol"));
}

TEST(Answer, OfOneMethodNeedsNoComparison) {
    const auto results = results_of("trials = 40", R"([[method]]
name = "random"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = 64
)");
    EXPECT_THAT(answer(results).text, StartsWith("On parallel pairs random has an RMSE of "));
    EXPECT_THAT(answer(results).text, Not(HasSubstr("smallest")));
}

TEST(Answer, IsTheFirstThingThatMarkdownSays) {
    const std::string text = markdown_report(test::small_results());
    EXPECT_LT(text.find("*Which method has the smallest error?*"), text.find("## In brief"));
}

TEST(Headline, CountsContradictionsAsItListsThem) {
    const Headline top = headline(test::published_results());
    EXPECT_EQ(top.published.size(), test::published_results().published->audit.contradictions());
    EXPECT_EQ(top.numbers.back().value, std::to_string(top.published.size()));
}

}  // namespace
}  // namespace ff::reports
