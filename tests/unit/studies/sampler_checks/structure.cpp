#include "studies/sampler_checks/structure.hpp"

#include "samplers/point_sets/draw_set.hpp"
#include "studies/sampler_checks/point_groups.hpp"
#include "tests/unit/studies/sampler_checks/made_samplers.hpp"

#include <gtest/gtest.h>

namespace ff::studies {
namespace {

samplers::PointSet set_of_sampler(std::string_view name, std::uint64_t points, std::size_t dimension) {
    return samplers::draw_set(samplers::find(name), {points, dimension});
}

TEST(Structure, CountsValuesAndSlices) {
    const auto set = test::set_of({{0.1, 0.5}, {0.1, 0.6}, {0.3, 0.5}, {0.9, 0.1}});
    const SetStructure found = structure_of(set, 0, 2);
    EXPECT_EQ(found.coordinates[0].values, 3u);
    EXPECT_EQ(found.coordinates[0].equal_pairs, 1u);
    EXPECT_EQ(found.coordinates[0].runs, 3u);
    EXPECT_EQ(found.coordinates[0].single_slices, 2u);
    EXPECT_EQ(found.coordinates[1].values, 3u);
    EXPECT_EQ(found.coordinates[1].runs, 4u);
    EXPECT_EQ(found.coordinates[1].repeats_as, 1u);
    EXPECT_EQ(found.cells_a_side, 2u);
    EXPECT_EQ(found.single_cells, 1u);
}

TEST(Structure, RecognisesNetsInAllCoordinatesAndInPairs) {
    const SetStructure found = structure_of(set_of_sampler("sobol", 64, 3), 0, 2);
    ASSERT_TRUE(found.t);
    EXPECT_LE(*found.t, 1u);
    ASSERT_EQ(found.pairs.size(), 3u);
    EXPECT_EQ(found.pairs.front().t, 0u);
    EXPECT_FALSE(found.lattice);
    EXPECT_EQ(structure_of(set_of_sampler("faure", 625, 4), 0, 5).t, 0u);
    EXPECT_FALSE(structure_of(set_of_sampler("sobol", 100, 3), 0, 2).t);
}

TEST(Structure, TakesTheBaseOfTheNumberOfPoints) {
    EXPECT_EQ(base_of_structure(64, 0), 2u);
    EXPECT_EQ(base_of_structure(243, 0), 3u);
    EXPECT_EQ(base_of_structure(625, 0), 5u);
    EXPECT_EQ(base_of_structure(100, 0), 2u);
    EXPECT_EQ(base_of_structure(64, 5), 5u);
}

TEST(Structure, RecognisesLatticesOfAnySizeAndShift) {
    EXPECT_FALSE(first_off_lattice(set_of_sampler("lattice", 256, 4), 0));
    for (const std::size_t n : {7u, 55u, 100u, 1000u}) {
        test::Rows rows(n, std::vector<double>(2));
        for (std::size_t i = 0; i < n; ++i) {
            rows[i][0] = std::fmod(0.1234567 + static_cast<double>(i) / static_cast<double>(n), 1.0);
            rows[i][1] = std::fmod(0.7654321 + static_cast<double>(21 * i % n) / static_cast<double>(n), 1.0);
        }
        EXPECT_FALSE(first_off_lattice(test::set_of(rows), 0)) << n;
        rows[n / 2][1] = std::fmod(rows[n / 2][1] + 1.0 / static_cast<double>(n), 1.0);
        EXPECT_TRUE(first_off_lattice(test::set_of(rows), 0)) << n;
    }
    EXPECT_TRUE(first_off_lattice(set_of_sampler("random", 64, 2), 0));
}

TEST(Structure, FindsTheNetBeforeAShift) {
    std::mt19937_64 random(1);
    const auto digital = test::set_of(test::net_rows(64, 2, random, 0, true));
    EXPECT_TRUE(is_digital(digital, 0));
    EXPECT_FALSE(net_before_shift(digital, 0));
    const auto shifted = test::set_of(test::net_rows(64, 2, random, 0, false));
    EXPECT_FALSE(is_digital(shifted, 0));
    const auto net = net_before_shift(shifted, 0);
    ASSERT_TRUE(net);
    EXPECT_EQ(structure_of(*net, 0, 2).t, 0u);
    EXPECT_GT(structure_of(shifted, 0, 2).t, 0u);
    EXPECT_FALSE(net_before_shift(set_of_sampler("lattice", 64, 2), 0));
    EXPECT_FALSE(net_before_shift(set_of_sampler("sobol", 64, 2), 0));
}

}  // namespace
}  // namespace ff::studies
