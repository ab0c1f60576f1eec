#include "samplers/point_sets/point_set.hpp"

#include "samplers/outside/added.hpp"

#include "core/support/error.hpp"
#include "tests/unit/samplers/blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace ff::samplers {
namespace {

/// n points on a diagonal, as a set of one or more sets that differ.
std::shared_ptr<const PointSet> diagonal(std::uint64_t points, std::size_t dimension, std::uint64_t sets) {
    auto set = std::make_shared<PointSet>(PointSet{points, dimension, sets, {}});
    for (std::uint64_t row = 0; row < sets * dimension; ++row) {
        for (std::uint64_t i = 0; i < points; ++i)
            set->coordinate.push_back(static_cast<std::uint32_t>((i << 32) / points + row / dimension));
    }
    return set;
}

PointBlock block_in_plane(const PointSource& source, const Stream& stream, PointIndex first, std::size_t size) {
    return test::block_of(source, stream, first, size, 2);
}

/// Whether each interval of length 2^-6 holds one of 64 points.
bool is_stratified(std::span<const std::uint32_t> row) {
    std::vector<std::uint32_t> cells;
    for (const std::uint32_t x : row) cells.push_back(x >> 26);
    std::sort(cells.begin(), cells.end());
    return std::unique(cells.begin(), cells.end()) == cells.end();
}

TEST(PointSet, UsesOneStoredSetPerTrialWithoutRandomisation) {
    const auto source = points_of_set(diagonal(64, 2, 3), 64, Randomisation::none);
    EXPECT_TRUE(source->randomised());
    EXPECT_FALSE(points_of_set(diagonal(64, 2, 1), 64, Randomisation::none)->randomised());
    for (std::uint32_t trial = 0; trial < 6; ++trial) {
        const PointBlock block = block_in_plane(*source, {.key = {}, .trial = trial}, 5, 2);
        EXPECT_EQ(block.coordinate[0][0], (5u << 26) + trial % 3);
        EXPECT_EQ(block.coordinate[1][1], (6u << 26) + trial % 3);
    }
}

TEST(PointSet, GivesTheSameBitsInBlocksOfAnySize) {
    for (std::size_t how = 0; how < randomisation_names.size(); ++how) {
        const auto source = points_of_set(diagonal(64, 2, 1), 64, static_cast<Randomisation>(how));
        const PointBlock all = block_in_plane(*source, {.key = {}, .trial = 7}, 0, 64);
        for (PointIndex first = 0; first + 5 <= 64; ++first) {
            const PointBlock part = block_in_plane(*source, {.key = {}, .trial = 7}, first, 5);
            for (std::size_t i = 0; i < 5; ++i)
                EXPECT_EQ(part.coordinate[1][i], all.coordinate[1][first + i]) << randomisation_names.at(how);
        }
    }
}

TEST(PointSet, KeepsNetsUnderDigitalRandomisationsOnly) {
    const auto set = diagonal(64, 2, 1);
    for (const auto how : {Randomisation::digital_shift, Randomisation::lms, Randomisation::owen}) {
        const auto source = points_of_set(set, 64, how);
        for (std::uint32_t trial = 0; trial < 50; ++trial) {
            const PointBlock block = block_in_plane(*source, {.key = {}, .trial = trial}, 0, 64);
            EXPECT_TRUE(is_stratified(std::span(block.coordinate[0]).first(64)));
        }
    }
}

TEST(PointSet, KeepsDistancesUnderShift) {
    const auto source = points_of_set(diagonal(64, 2, 1), 64, Randomisation::shift);
    const PointBlock block = block_in_plane(*source, {.key = {}, .trial = 3}, 0, 64);
    for (std::size_t i = 1; i < 64; ++i) EXPECT_EQ(block.coordinate[0][i] - block.coordinate[0][i - 1], 1u << 26);
}

TEST(PointSet, RandomisesEveryCoordinateAndTrialSeparately) {
    for (const auto how :
         {Randomisation::shift, Randomisation::digital_shift, Randomisation::lms, Randomisation::owen}) {
        const auto source = points_of_set(diagonal(64, 2, 1), 64, how);
        const PointBlock block = block_in_plane(*source, {.key = {}, .trial = 0}, 0, 1);
        EXPECT_NE(block.coordinate[0][0], block.coordinate[1][0]);
        EXPECT_NE(block.coordinate[0][0], block_in_plane(*source, {.key = {}, .trial = 1}, 0, 1).coordinate[0][0]);
        EXPECT_NE(block.coordinate[0][0], block_in_plane(*source, {.key = {}, .source = 1}, 0, 1).coordinate[0][0]);
    }
}

TEST(AddedSamplers, AreFoundByNameAndNotReplacedByLaterOnes) {
    const auto sampler = [](std::string summary) {
        return std::make_unique<AddedSampler>(
            AddedSampler::Texts{"added_for_a_test", std::move(summary), ""}, SamplerInfo{},
            std::vector<std::uint64_t>{16, 64}, [](const PointSetSpec& spec) {
                return points_of_set(diagonal(64, 4, 1), spec.points, Randomisation::owen);
            });
    };
    EXPECT_THROW(find("added_for_a_test"), UserError);
    add(sampler("first"));
    EXPECT_EQ(add(sampler("second")).info.summary, "first");
    EXPECT_EQ(find("added_for_a_test").make({.points = 16})->points(), 16u);
    EXPECT_THROW(static_cast<void>(find("added_for_a_test").make({.points = 65})), UserError);
    EXPECT_THROW(static_cast<void>(find("added_for_a_test").make({.points = 16, .dimension = 5})), UserError);
    EXPECT_TRUE(check_size(find("added_for_a_test").info, 64).message.empty());
    EXPECT_FALSE(check_size(find("added_for_a_test").info, 63).fatal);
    EXPECT_FALSE(check_size(find("added_for_a_test").info, 63).message.empty());
}

TEST(AddedSamplers, CannotReuseNamesOfTheCatalogue) {
    EXPECT_THROW(add(std::make_unique<AddedSampler>(AddedSampler::Texts{"sobol", "", ""}, SamplerInfo{},
                                                    std::vector<std::uint64_t>{}, nullptr)),
                 UserError);
}

}  // namespace
}  // namespace ff::samplers
