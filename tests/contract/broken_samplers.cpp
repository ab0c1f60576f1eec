#include "tests/contract/broken_samplers.hpp"

#include "tests/contract/assertions.hpp"
#include "tests/contract/checks.hpp"

// Every check catches the fault that it is meant for.

namespace ff::test {
namespace {

using samplers::entry;
using samplers::find;

TEST(CoordinatesAreUniform, CatchesOneBiasedCoordinate) {
    EXPECT_FALSE(coordinates_are_uniform(entry<BiasedCoordinate>()));
}

TEST(CoordinatesAreUniform, CatchesOriginsInTheMiddleOfThePatch) {
    EXPECT_FALSE(coordinates_are_uniform(find("patch_centres")));
}

TEST(PairsAreUniform, CatchesEqualCoordinatesThatAreEachUniform) {
    EXPECT_FALSE(pairs_are_uniform(entry<EqualCoordinates>()));
    EXPECT_TRUE(coordinates_are_uniform(entry<EqualCoordinates>()));
}

TEST(StreamsDiffer, CatchesOneSeedForAllTrials) {
    EXPECT_FALSE(streams_differ(find("same_seed")));
}

TEST(StreamsDiffer, CatchesOneSeedForAllSources) {
    EXPECT_FALSE(streams_differ(entry<SameForEverySource>()));
}

TEST(TrialsAreIndependent, CatchesTrialsThatShareAState) {
    EXPECT_FALSE(trials_are_independent(entry<CorrelatedTrials>()));
    EXPECT_TRUE(coordinates_are_uniform(entry<CorrelatedTrials>()));
}

TEST(IsPure, CatchesPointsNumberedByBlock) {
    EXPECT_FALSE(is_pure(entry<NumberedByBlock>()));
}

TEST(FillsItsStrata, CatchesTheFirstPointDropped) {
    EXPECT_FALSE(fills_its_strata(find("sobol_first_dropped")));
    EXPECT_TRUE(coordinates_are_uniform(find("sobol_first_dropped")));
}

TEST(FillsItsStrata, CatchesDigitsShuffledWrongly) {
    EXPECT_FALSE(fills_its_strata(find("sobol_digits_reversed")));
}

TEST(FillsItsStrata, CatchesOverlappingCells) {
    EXPECT_FALSE(fills_its_strata(entry<OverlappingCells>()));
}

TEST(FillsItsStrata, CatchesForgottenWeights) {
    EXPECT_FALSE(fills_its_strata(entry<WeightsForgotten>()));
}

TEST(WeightsAddUp, CatchesDoubledWeights) {
    EXPECT_FALSE(weights_add_up(entry<DoubledWeights>()));
}

TEST(IntegratesWithoutBias, CatchesNumbersWithoutSpread) {
    EXPECT_FALSE(integrates_without_bias(entry<FixedPoints>()));
}

TEST(IntegratesWithoutBias, CatchesMissingLargeCoordinates) {
    EXPECT_FALSE(integrates_without_bias(entry<ShrunkCoordinate>()));
}

TEST(SuccessivePointsAreFree, CatchesSobolPointsDeclaredFree) {
    EXPECT_FALSE(successive_points_are_free(entry<FalselyIndependent>()));
}

TEST(DescribesItself, CatchesMissingDetails) {
    EXPECT_FALSE(describes_itself(entry<FalselyIndependent>()));
}

TEST(EquallyLikely, FailsWhereDrawsAreTooFewToNotice) {
    const std::array<std::uint64_t, 4> counts{25, 25, 25, 25};
    EXPECT_FALSE(equally_likely(counts, {.alpha = 1e-6, .detects = 0.05}));
    EXPECT_TRUE(equally_likely(counts, {.alpha = 1e-6, .detects = 1}));
}

}  // namespace
}  // namespace ff::test
