#include "reports/pictures/pictures.hpp"

#include "reports/text/labels.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace ff::reports {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// Sobol' points beside independent ones, and strata, whose sizes are others.
const studies::StudyResults& equal_and_other_sizes() {
    static const studies::StudyResults made =
        studies::evaluate(test::run(test::plan_of(test::study_text("trials = 40", R"([[method]]
name = "random"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = [64, 256, 1024]
[[method]]
name = "sobol"
sampler = "sobol"
estimator = "ray_shooting"
samples_per_patch = [64, 256, 1024]
[[method]]
name = "strata"
sampler = "stratified"
estimator = "ray_shooting"
samples_per_patch = [81, 256, 1296]
[[method]]
name = "large"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = 8192
)"))));
    return made;
}

TEST(ErrorsAtSizes, ExistForEverySizeThatSeveralMethodsShare) {
    std::vector<std::string> names;
    for (const Picture& picture : errors_at_sizes(equal_and_other_sizes())) names.push_back(picture.name);
    EXPECT_THAT(names, ElementsAre("errors at 64 evaluations per face", "errors at 256 evaluations per face",
                                   "errors at 1024 evaluations per face"));
}

TEST(ErrorsAtSizes, RankMethodsAndNameSizesThatDiffer) {
    const auto pictures = errors_at_sizes(equal_and_other_sizes());
    const json order = json::parse(pictures.back().values)["scales"]["y"]["domain"];
    // With these trials the errors of independent rays are twice those of Sobol' points; none comes near.
    EXPECT_EQ(order[0], "parallel pairs");
    EXPECT_EQ(order[1], "parallel pairs|sobol");
    EXPECT_THAT(order.dump(), HasSubstr("strata (1296)"));
    EXPECT_THAT(pictures.back().finding, HasSubstr("shown at theirs"));
    EXPECT_THAT(json::parse(pictures[1].values).dump(), Not(HasSubstr("strata (")));
}

TEST(ErrorsAtSizes, DoNotRankUnrandomisedPointSets) {
    const auto pictures =
        errors_at_sizes(studies::evaluate(test::run(test::plan_of(test::study_text("trials = 40", R"([[method]]
name = "raw"
sampler = "sobol_raw"
estimator = "ray_shooting"
samples_per_patch = 1024
[[method]]
name = "random"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = 1024
[[method]]
name = "sobol"
sampler = "sobol"
estimator = "ray_shooting"
samples_per_patch = 1024
)")))));
    ASSERT_EQ(pictures.size(), 1u);
    const json order = json::parse(pictures[0].values)["scales"]["y"]["domain"];
    EXPECT_EQ(order[1], "parallel pairs|sobol");
    EXPECT_EQ(order[3], "parallel pairs|raw");
    EXPECT_THAT(pictures[0].finding, HasSubstr("may be luck"));
}

TEST(ErrorsAtSizes, AreOfferedAsAlternativesToConvergenceRates) {
    const auto lead = lead_picture(equal_and_other_sizes());
    ASSERT_TRUE(lead);
    EXPECT_EQ(lead->name, "convergence rates");
    EXPECT_EQ(lead->alternatives.size(), 3u);
}

}  // namespace
}  // namespace ff::reports
