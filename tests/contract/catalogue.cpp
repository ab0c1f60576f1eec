#include "samplers/sampler.hpp"
#include "tests/contract/checks.hpp"

#include <iterator>
#include <ostream>
#include <set>
#include <vector>

// The contract over the whole catalogue. No sampler is named here: a new one is tested as soon as it is listed.

namespace ff::samplers {

/// How gtest prints a parameter.
// NOLINTNEXTLINE(readability-identifier-naming): gtest's name
void PrintTo(const CatalogueEntry& sampler, std::ostream* out) {
    *out << sampler.info.name;
}

}  // namespace ff::samplers

namespace ff::test {
namespace {

using samplers::CatalogueEntry;

template <class Predicate>
std::vector<CatalogueEntry> samplers_where(Predicate predicate) {
    std::vector<CatalogueEntry> result;
    for (const CatalogueEntry& sampler : samplers::catalogue()) {
        if (predicate(sampler.info)) result.push_back(sampler);
    }
    return result;
}

const auto every = samplers_where([](const auto&) { return true; });
const auto randomised = samplers_where([](const auto& info) { return info.randomised; });
const auto independent = samplers_where([](const auto& info) { return info.independent(); });
const auto name_of = [](const auto& parameter) { return std::string(parameter.param.info.name); };

class EverySampler : public testing::TestWithParam<CatalogueEntry> {};
INSTANTIATE_TEST_SUITE_P(Catalogue, EverySampler, testing::ValuesIn(every), name_of);

TEST_P(EverySampler, DescribesItself) {
    EXPECT_TRUE(describes_itself(GetParam()));
}
TEST_P(EverySampler, RefusesImpossiblePointSets) {
    EXPECT_TRUE(refuses_impossible_sets(GetParam()));
}
TEST_P(EverySampler, MakesEachPointFromItsIndexAlone) {
    EXPECT_TRUE(is_pure(GetParam()));
}
TEST_P(EverySampler, DiffersBetweenStreamsIfRandomised) {
    EXPECT_TRUE(streams_differ(GetParam()));
}
TEST_P(EverySampler, HasWeightsThatSumToOne) {
    EXPECT_TRUE(weights_add_up(GetParam()));
}
TEST_P(EverySampler, GivesTheSamePointsInBothKindsOfBlock) {
    EXPECT_TRUE(blocks_agree(GetParam()));
}
TEST_P(EverySampler, FillsItsStrata) {
    EXPECT_TRUE(fills_its_strata(GetParam()));
}

class RandomisedSampler : public testing::TestWithParam<CatalogueEntry> {};
INSTANTIATE_TEST_SUITE_P(Catalogue, RandomisedSampler, testing::ValuesIn(randomised), name_of);

TEST_P(RandomisedSampler, HasUniformCoordinates) {
    EXPECT_TRUE(coordinates_are_uniform(GetParam()));
}
TEST_P(RandomisedSampler, HasUniformPairsOfCoordinates) {
    EXPECT_TRUE(pairs_are_uniform(GetParam()));
}
TEST_P(RandomisedSampler, HasIndependentTrials) {
    EXPECT_TRUE(trials_are_independent(GetParam()));
}
TEST_P(RandomisedSampler, IntegratesWithoutBias) {
    EXPECT_TRUE(integrates_without_bias(GetParam()));
}

class IndependentSampler : public testing::TestWithParam<CatalogueEntry> {};
INSTANTIATE_TEST_SUITE_P(Catalogue, IndependentSampler, testing::ValuesIn(independent), name_of);

TEST_P(IndependentSampler, HasIndependentSuccessivePoints) {
    EXPECT_TRUE(successive_points_are_free(GetParam()));
}

TEST(Catalogue, NamesEachSamplerOnce) {
    std::set<std::string_view> names;
    for (const CatalogueEntry& sampler : samplers::catalogue()) names.insert(sampler.info.name);
    EXPECT_EQ(names.size(), samplers::catalogue().size());
}

}  // namespace
}  // namespace ff::test
