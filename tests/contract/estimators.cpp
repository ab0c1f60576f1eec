#include "core/estimators/entry.hpp"
#include "core/estimators/pairs/solid_angle.hpp"
#include "core/geometry/scene.hpp"
#include "tests/contract/estimator_checks.hpp"

#include <algorithm>
#include <ostream>
#include <string>
#include <tuple>
#include <vector>

// The contract over the whole catalogue of estimators. None is named except those broken on purpose: a new one is
// tested as soon as it is listed.

namespace ff {

/// How gtest prints a parameter.
// NOLINTNEXTLINE(readability-identifier-naming): gtest's name
void PrintTo(const EstimatorEntry& estimator, std::ostream* out) {
    *out << estimator.info.name;
}

// NOLINTNEXTLINE(readability-identifier-naming): gtest's name
void PrintTo(const Configuration& configuration, std::ostream* out) {
    *out << configuration.name;
}

}  // namespace ff

namespace ff::test {
namespace {

class EveryEstimator : public testing::TestWithParam<EstimatorEntry> {};
INSTANTIATE_TEST_SUITE_P(Catalogue, EveryEstimator, testing::ValuesIn(estimators()),
                         [](const auto& parameter) { return std::string(parameter.param.info.name); });

TEST_P(EveryEstimator, DeclaresItself) {
    EXPECT_TRUE(declares_itself(GetParam()));
}
TEST_P(EveryEstimator, SaysWhyItRefusesAScene) {
    EXPECT_TRUE(says_why_not(GetParam()));
}
TEST_P(EveryEstimator, GivesTheSameBitsForTheSameTask) {
    EXPECT_TRUE(depends_on_its_task(GetParam()));
}

std::vector<Configuration> configurations_with_scenes() {
    std::vector<Configuration> result;
    for (const Configuration& configuration : configurations()) {
        if (configuration.kind == ConfigurationKind::surfaces) result.push_back(configuration);
    }
    return result;
}

class EveryEstimatorAndConfiguration : public testing::TestWithParam<std::tuple<EstimatorEntry, Configuration>> {};
INSTANTIATE_TEST_SUITE_P(Catalogue, EveryEstimatorAndConfiguration,
                         testing::Combine(testing::ValuesIn(estimators()),
                                          testing::ValuesIn(configurations_with_scenes())),
                         [](const auto& parameter) {
                             return std::string(std::get<0>(parameter.param).info.name) + "_" +
                                    std::string(std::get<1>(parameter.param).name);
                         });

// About 190 pairs, those refused included, at 1e-8 each: 2e-6 together.
TEST_P(EveryEstimatorAndConfiguration, IsUnbiased) {
    EXPECT_TRUE(is_unbiased(std::get<0>(GetParam()), std::get<1>(GetParam())));
}

const Configuration& configuration_named(std::string_view name) {
    return *std::find_if(configurations().begin(), configurations().end(),
                         [name](const Configuration& c) { return c.name == name; });
}

/// Sees through what stands in between.
class Blind : public SolidAngle {
  public:
    Blind(const Scene& scene, TracerChoice tracer) : SolidAngle(scene, tracer), scene_(scene) {
        std::erase_if(scene_.surfaces, [](const Surface& surface) { return surface.face == no_face; });
    }
    void observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& totals) const {
        SolidAngle(scene_, TracerChoice::automatic).observe(task, outcome, totals);
    }

  private:
    Scene scene_;
};

/// Gives too much by some tenths of a percent.
template <int tenths_of_a_percent>
class Larger : public SolidAngle {
  public:
    using SolidAngle::SolidAngle;
    void observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& totals) const {
        SolidAngle::observe(task, outcome, totals);
        outcome.estimates *= 1 + tenths_of_a_percent / 1000.0;
    }
};

/// Draws the same points in every trial.
class SameTrial : public SolidAngle {
  public:
    using SolidAngle::SolidAngle;
    void observe(EstimatorTask task, Outcome& outcome, PatchTotals& totals) const {
        task.trial = 0;
        SolidAngle::observe(task, outcome, totals);
    }
};

TEST(IsUnbiasedOfEstimators, CatchesEstimatorsThatSeeThroughOccluders) {
    EXPECT_FALSE(is_unbiased(estimator_entry<Blind>(), configuration_named("squares_blocked")));
    EXPECT_TRUE(is_unbiased(estimator_entry<Blind>(), configuration_named("cube_adjacent_faces")));
}

// The smallest bias that has to be noticed is 0.03 sqrt(0.2) = 0.0134, 6.7 % of the factor.
TEST(IsUnbiasedOfEstimators, CatchesABiasOfThePromisedSize) {
    EXPECT_FALSE(is_unbiased(estimator_entry<Larger<67>>(), configuration_named("cube_adjacent_faces")));
    EXPECT_TRUE(is_unbiased(estimator_entry<Larger<0>>(), configuration_named("cube_adjacent_faces")));
}

TEST(DependsOnItsTask, CatchesTheSamePointsInEveryTrial) {
    EXPECT_FALSE(depends_on_its_task(estimator_entry<SameTrial>()));
}

}  // namespace
}  // namespace ff::test
