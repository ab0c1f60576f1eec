#include "tests/validation/form_factors/plain_reference.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/configurations/catalogue.hpp"
#include "core/geometry/scene.hpp"
#include "tests/support/statistical_assertions.hpp"
#include "tests/validation/form_factors/facet_scenes.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace ff::studies::form_factors {
namespace {

/// How many of 60 references hold a value that is off by this share.
std::uint64_t references_that_hold(const char* name, double off) {
    const Scene scene = built_in_scene(name);
    const double exact = (1 + off) * *known_form_factor(scene, 0, 1) * area(scene.surfaces[0].shape);
    std::uint64_t held = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        const PlainReference found =
            plain_reference(scene, 0, 1, {.accuracy = 1e-4}, derive_key(Seed{seed}, "plain reference"));
        held += found.low <= exact && exact <= found.high;
    }
    return held;
}

// Rates of 0.95 would be held, with an error of 1e-3 in all, and 0.8 would be noticed with probability 0.9.
TEST(PlainReference, HoldsExactValuesAsOftenAsStated) {
    const test::StatisticalRisk risk{.alpha = 1e-3, .detects = 0.2, .power = 0.9};
    for (const char* name : {"squares_blocked", "squares_through_aperture"}) {
        EXPECT_TRUE(test::has_probability_at_least(references_that_hold(name, 0), 60, 0.95, risk)) << name;
        EXPECT_EQ(references_that_hold(name, 0.01), 0u) << name;
    }
}

// A facet of the inner cube, its neighbours and what touches it: the lowest squares of a wall see all of the wall
// opposite but what the cube hides.
TEST(PlainReference, AddsUpToOneOverAClosedRoom) {
    const Scene scene = nested_cubes_of_facets(3, 2);
    for (const std::size_t from : {std::size_t{0}, std::size_t{20}, scene.surfaces.size() - 1}) {
        double sum = 0;
        double room = 0;
        for (std::size_t to = 0; to < scene.surfaces.size(); ++to) {
            if (to == from) continue;
            const PlainReference found =
                plain_reference(scene, from, to, {.accuracy = 1e-6, .randomisations = 32, .most_points = 512},
                                derive_key(Seed{1}, "room"));
            sum += found.value;
            room += std::pow((found.high - found.low) / 2, 2);
        }
        EXPECT_NEAR(sum / area(scene.surfaces[from].shape), 1, 2 * std::sqrt(room) / area(scene.surfaces[from].shape));
        EXPECT_LT(std::sqrt(room), 1e-4 * area(scene.surfaces[from].shape));
    }
}

}  // namespace
}  // namespace ff::studies::form_factors
