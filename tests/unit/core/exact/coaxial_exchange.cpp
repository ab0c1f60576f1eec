#include "core/exact/coaxial_exchange.hpp"

#include "core/configurations/catalogue.hpp"
#include "core/exact/pair_exchange.hpp"
#include "core/geometry/scene.hpp"
#include "tests/support/round_scenes.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;
using test::disc;
using test::sphere;
using test::wall;

Vector3d up(double height) {
    return test::somewhere + height * test::tilted;
}

/// A furnace of radius 1 and height 3 whose floor, wall and roof are divided; the wall ends in a cone.
std::vector<Surface> furnace() {
    return {disc(up(0), test::tilted, 0.4),
            disc(up(0), test::tilted, 1, 0.4),
            wall(up(0), 1 * test::tilted, 1, 1, Facing::inward),
            wall(up(2.5), -1.5 * test::tilted, 1, 1, Facing::inward),
            wall(up(2.5), 0.5 * test::tilted, 1, 0.5, Facing::inward),
            disc(up(3), -test::tilted, 0.5)};
}

TEST(CoaxialExchange, IsTheKnownFactorOfTheCatalogue) {
    for (const char* name : {"coaxial_discs_equal", "coaxial_discs_unequal", "cylinder_wall", "cylinder_base_to_wall",
                             "sphere_caps", "hemisphere", "cone_wall"}) {
        const Scene scene = configuration_scene(name).value();
        const auto configuration = std::ranges::find(configurations(), std::string_view(name), &Configuration::name);
        const auto from = static_cast<std::size_t>(configuration->from);
        const auto to = static_cast<std::size_t>(configuration->to);
        const PairExchange found = pair_exchange(Occluders(scene), from, to, 1e-9);
        EXPECT_EQ(found.reason, ExchangeReason::coaxial) << name;
        ASSERT_TRUE(found.area) << name;
        EXPECT_NEAR(found.area->value / area(scene.surfaces[from].shape), static_cast<double>(configuration->exact()),
                    1e-14)
            << name;
    }
}

TEST(CoaxialExchange, FillsARowOfADividedFurnace) {
    const Scene scene = test::faces_of(furnace(), true);
    const Occluders occluders(scene);
    for (std::size_t from = 0; from < scene.surfaces.size(); ++from) {
        double sum = 0;
        for (std::size_t to = 0; to < scene.surfaces.size(); ++to) {
            const PairExchange found = pair_exchange(occluders, from, to, 1e-9);
            ASSERT_TRUE(found.area && found.method != ExchangeMethod::rays) << from << " " << to;
            EXPECT_GE(found.area->value, 0) << from << " " << to;
            sum += found.area->value;
        }
        EXPECT_NEAR(sum, area(scene.surfaces[from].shape), 1e-12) << from;
    }
}

TEST(CoaxialExchange, FillsARowOfACapsuleAndALens) {
    const std::vector<Surface> capsule{sphere(up(1), 1, Facing::inward, -1, 0),
                                       wall(up(1), 2 * test::tilted, 1, 1, Facing::inward),
                                       sphere(up(3), 1, Facing::inward, 0, 1)};
    // Two spheres of radius 1 whose centres are 1.2 apart: they meet at 0.6 of their radii.
    const std::vector<Surface> lens{sphere(up(0), 1, Facing::inward, 0.6, 1),
                                    sphere(up(1.2), 1, Facing::inward, -1, -0.6)};
    for (const std::vector<Surface>& room : {capsule, lens}) {
        for (const Surface& from : room) {
            double sum = 0;
            for (const Surface& to : room) {
                const auto found = coaxial_exchange_area(from, to, {});
                ASSERT_TRUE(found);
                sum += found->value;
            }
            EXPECT_NEAR(sum, area(from.shape), 1e-12);
        }
    }
    // Between two balls that overlap less than half, something is behind the rim.
    EXPECT_FALSE(coaxial_exchange_area(sphere(up(0), 1, Facing::inward, -1, 0.6),
                                       sphere(up(1.2), 1, Facing::inward, -0.6, 1), {}));
}

TEST(CoaxialExchange, IsTheExchangeOfTheDiscsThatWallsEndIn) {
    // What leaves a disc and reaches a wall beyond it passes through one end of the wall and not through the other.
    const Surface floor = disc(up(0), test::tilted, 0.8);
    const Surface section = wall(up(1), 0.5 * test::tilted, 1, 1, Facing::inward);
    const auto through = [&](double height) {
        return coaxial_exchange_area(floor, disc(up(height), -test::tilted, 1), {})->value;
    };
    EXPECT_NEAR(coaxial_exchange_area(floor, section, {})->value, through(1) - through(1.5), 1e-14);
    EXPECT_NEAR(coaxial_exchange_area(section, floor, {})->value, through(1) - through(1.5), 1e-14);
    // In a sphere each part receives its share of all that leaves.
    const Surface zone = sphere(up(0), 2, Facing::inward, -0.3, 0.2);
    const Surface cap = sphere(up(0), 2, Facing::inward, 0.7, 1);
    const double whole = 16 * std::numbers::pi;
    const auto expected = [&](const Surface& a, const Surface& b) { return area(a.shape) * area(b.shape) / whole; };
    EXPECT_NEAR(coaxial_exchange_area(zone, cap, {})->value, expected(zone, cap), 1e-13);
    EXPECT_NEAR(coaxial_exchange_area(zone, zone, {})->value, expected(zone, zone), 1e-13);
}

TEST(CoaxialExchange, IsEmptyWhereSomethingIsHidden) {
    const Surface floor = disc(up(0), test::tilted, 1);
    const Surface roof = disc(up(3), -test::tilted, 1);
    const Surface side = wall(up(0), 3 * test::tilted, 1, 1, Facing::inward);
    EXPECT_FALSE(coaxial_exchange_area(floor, disc(up(3), test::tilted, 1), {})) << "turned away";
    EXPECT_FALSE(coaxial_exchange_area(disc(up(1), test::tilted, 0.5), side, {})) << "partly behind the disc";
    EXPECT_FALSE(coaxial_exchange_area(floor, wall(up(0), 3 * test::tilted, 1, 1, Facing::outward), {}));
    EXPECT_FALSE(coaxial_exchange_area(side, wall(up(3), test::tilted, 1, 2, Facing::inward), {}))
        << "a funnel on a can";
    EXPECT_FALSE(coaxial_exchange_area(side, disc(up(0) + Vector3d(1e-9, 0, 0), test::tilted, 1), {}))
        << "off the axis";
    EXPECT_FALSE(coaxial_exchange_area(disc(up(0), test::tilted, 2), side, {})) << "reaches out of the can";
    const auto past = [&](const Surface& from, const Surface& to, const Surface& blocker) {
        const std::vector<Blocker> between{&blocker};
        return coaxial_exchange_area(from, to, between).has_value();
    };
    EXPECT_TRUE(past(side, side, roof));
    EXPECT_TRUE(past(floor, roof, side));
    EXPECT_TRUE(past(floor, roof, wall(up(1), test::tilted, 1.2, 1.1, Facing::outward)));
    EXPECT_TRUE(past(side, floor, disc(up(3), test::tilted, 5)));
    EXPECT_FALSE(past(floor, roof, wall(up(1), test::tilted, 0.9, 1.1, Facing::outward)));
    EXPECT_FALSE(past(floor, roof, disc(up(2), test::tilted, 0.1)));
    EXPECT_FALSE(past(side, side, sphere(up(1), 0.1, Facing::outward)));
    // The roof is smaller: a cone around both has to lie outside of the straight line between their rims.
    const Surface small_roof = disc(up(3), -test::tilted, 0.5);
    EXPECT_TRUE(past(floor, small_roof, wall(up(0), 3 * test::tilted, 1, 0.5, Facing::inward)));
    EXPECT_FALSE(past(floor, small_roof, wall(up(0), 3 * test::tilted, 0.99, 0.5, Facing::inward)));
    EXPECT_FALSE(past(floor, small_roof, wall(up(0), 3 * test::tilted, 1, 0.49, Facing::inward)));
}

}  // namespace
}  // namespace ff
