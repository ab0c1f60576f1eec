#include "reports/pictures/pictures.hpp"

#include "tests/support/studies.hpp"
#include "tests/unit/reports/small_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace ff::reports {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

const studies::StudyResults& rays_and_kernel() {
    static const studies::StudyResults made = studies::evaluate(test::run(test::plan_of(R"([study]
name = "ladders"
scene = "cube"
trials = 20
seed = 3

[[method]]
name = "rays"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = [64, 128, 256]

[[method]]
name = "kernel"
sampler = "random"
estimator = "area_kernel"
samples_per_patch = [64, 128, 256]
)")));
    return made;
}

/// Rows of a method in a role: [evaluations, error].
std::vector<std::pair<double, double>> points(const json& values, const std::string& method, const std::string& role) {
    std::vector<std::pair<double, double>> found;
    for (const json& row : values["rows"]) {
        if (row[0] == method && row[1] == role) found.emplace_back(row[3], row[4]);
    }
    return found;
}

json convergence(const std::string& place) {
    const auto all = pictures_by_size(rays_and_kernel());
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Picture& picture) { return picture.id == "convergence-" + place; });
    return json::parse(found->values);
}

TEST(ConvergencePicture, HasALineWithTheExpectedSlopeThroughTheMiddleOfALadder) {
    const json values = convergence("parallel-pairs");
    const auto measured = points(values, "rays", "RMSE");
    const auto expected = points(values, "rays", "expected");
    ASSERT_EQ(measured.size(), 3u);
    ASSERT_EQ(expected.size(), 2u);
    const auto [first, last] = std::pair(expected[0], expected[1]);
    // Errors have four digits in the picture.
    EXPECT_NEAR(std::log(last.second / first.second) / std::log(last.first / first.first), -0.5, 1e-3);
    const double geometric_mean = std::cbrt(measured[0].second * measured[1].second * measured[2].second);
    EXPECT_NEAR(std::sqrt(first.second * last.second) / geometric_mean, 1, 1e-3);
}

TEST(ConvergencePicture, ShowsMediansWhereTheVarianceIsInfinite) {
    const json values = convergence("adjacent-pairs");
    EXPECT_TRUE(points(values, "kernel", "RMSE").empty());
    EXPECT_EQ(points(values, "kernel", "median").size(), 3u);
    EXPECT_EQ(points(values, "rays", "RMSE").size(), 3u);
}

TEST(ConvergencePicture, NamesEachLineAtItsEnd) {
    std::vector<std::string> names;
    const json values = convergence("adjacent-pairs");
    for (const json& label : values["labels"]) names.push_back(label["method"]);
    EXPECT_THAT(names, testing::IsSupersetOf({"rays", "kernel"}));
}

TEST(LeadPicture, ShowsErrorsPrintedInAPublicationBesideThoseOfItsMethods) {
    const auto picture = lead_picture(test::published_results());
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->id, "answer");
    EXPECT_EQ(picture->name, "adjacent pairs");
    EXPECT_THAT(picture->finding, HasSubstr("hollow: the printed figures"));
    const json values = json::parse(picture->values);
    constexpr double exact = 0.2000437761;
    const auto pdm = points(values, "PDM", "printed");
    const auto sr = points(values, "SR", "printed");
    ASSERT_EQ(pdm.size(), 1u);
    ASSERT_EQ(sr.size(), 1u);
    EXPECT_NEAR(pdm[0].second, 0.3 - exact, 1e-6);
    EXPECT_NEAR(sr[0].second, 0.9 - exact, 1e-6);
    EXPECT_EQ(points(values, "PDM", "RMSE").size(), 2u);
    EXPECT_THAT(answer_ranking(test::published_results())->values, HasSubstr("adjacent pairs|SR"));
}

TEST(UnfoldedPicture, IsDrawnForQuadratures) {
    const auto& results = test::published_results();  // SR with 4 patches per face, PDM with 4 and 9
    const auto four = unfolded_picture(results, 1);
    const auto nine = unfolded_picture(results, 2);
    ASSERT_TRUE(four && nine);
    EXPECT_THAT(four->finding, Not(HasSubstr("elsewhere"))) << "every patch lies along an edge";
    EXPECT_THAT(nine->finding, HasSubstr("elsewhere"));
    EXPECT_EQ(json::parse(nine->values)["rows"].size(), 54u + 6u) << "patches, and the labels of faces";
}

TEST(EstimatesPicture, NamesInItsLegendOnlyWhatItShows) {
    const auto shown = [](const studies::StudyResults& results, std::size_t cell) {
        return json::parse(estimates_picture(results, cell)->values)["signals"]["shown"].dump();
    };
    EXPECT_EQ(shown(test::published_results(), 0), R"(["exact","ours","95 % of single runs","published"])");
    EXPECT_EQ(shown(test::published_results(), 2), R"(["exact","ours"])") << "deterministic, not in print";
}

}  // namespace
}  // namespace ff::reports
