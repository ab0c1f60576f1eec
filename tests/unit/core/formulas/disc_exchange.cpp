#include "core/formulas/disc_exchange.hpp"

#include "core/configurations/closed_forms.hpp"
#include "core/geometry/scene.hpp"
#include "core/geometry/surface_map.hpp"
#include "samplers/grids/gauss_legendre.hpp"
#include "tests/support/round_scenes.hpp"
#include "tests/support/unit_cube.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace ff {
namespace {

using Eigen::Vector3d;
using test::disc;
using test::wall_at;

/// The value where it is known so well, or -1.
double disc_exchange(const Surface& from, const Surface& to, double wanted = 1e-13) {
    const auto area = disc_exchange_area(from, to, wanted);
    return area && area->error <= wanted ? area->value : -1;
}

double of_coaxial_discs(double r1, double r2, double distance) {
    return std::numbers::pi * r1 * r1 * static_cast<double>(coaxial_discs_factor(r1, r2, distance));
}

/// Gauss's rule for the kernel on surfaces that are wholly in front of each other.
double by_quadrature(const Surface& from, const Surface& to) {
    const samplers::GaussRule rule = samplers::gauss_rule(32);
    const auto places_of = [&](const Surface& surface) {
        const SurfaceMap map(surface);
        std::vector<std::pair<SurfacePoint, double>> places;
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
                // A disc's coordinate s is a square; the azimuth is periodic.
                const bool is_disc = std::holds_alternative<Disc>(surface.shape);
                const double r = rule.nodes[i];
                const double azimuth =
                    is_disc ? static_cast<double>(j) / static_cast<double>(rule.nodes.size()) : rule.nodes[j];
                const double weight_j = is_disc ? 1 / static_cast<double>(rule.nodes.size()) : rule.weights[j];
                const double weight_i = is_disc ? 2 * r * rule.weights[i] : rule.weights[i];
                places.emplace_back(map.at(is_disc ? r * r : r, azimuth), weight_i * weight_j * area(surface.shape));
            }
        }
        return places;
    };
    double sum = 0;
    const auto of_to = places_of(to);
    for (const auto& [x, weight_x] : places_of(from)) {
        for (const auto& [y, weight_y] : of_to) {
            const Vector3d way = y.position - x.position;
            const double square = way.squaredNorm();
            sum += weight_x * weight_y * x.normal.dot(way) * -y.normal.dot(way) / (std::numbers::pi * square * square);
        }
    }
    return sum;
}

TEST(DiscExchange, IsTheClosedFormOfCoaxialDiscs) {
    for (const auto& [r1, r2, h] : {std::tuple(1.0, 1.0, 1.0), {1.0, 0.2, 0.1}, {0.3, 2.0, 5.0}, {1.0, 1.0, 0.05}}) {
        const double expected = of_coaxial_discs(r1, r2, h);
        EXPECT_NEAR(disc_exchange(disc({0, 0, 0}, {0, 0, 1}, r1), disc({0, 0, h}, {0, 0, -1}, r2), 1e-11), expected,
                    1e-11)
            << r1 << " " << r2 << " " << h;
    }
    // Of an annulus it is the difference, in either order and at any place.
    const Vector3d place(3, -7, 11);
    const Vector3d axis = Vector3d(1, 2, -2).normalized();
    const double expected = of_coaxial_discs(1, 0.7, 0.5) - of_coaxial_discs(1, 0.4, 0.5);
    const Surface whole = disc(place, axis, 1);
    const Surface annulus = disc(place + 0.5 * axis, -axis, 0.7, 0.4);
    EXPECT_NEAR(disc_exchange(whole, annulus), expected, 1e-13);
    EXPECT_NEAR(disc_exchange(annulus, whole), expected, 1e-13);
}

TEST(DiscExchange, IsTheIntegralOfTheKernelInRandomPlaces) {
    std::mt19937_64 engine(11);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto direction = [&] { return Vector3d(uniform(engine), uniform(engine), uniform(engine)).normalized(); };
    int found = 0;
    for (int k = 0; k < 400 && found < 20; ++k) {
        const Surface one = disc({0, 0, 0}, direction(), 0.5, k % 3 == 0 ? 0.2 : 0);
        const Vector3d there = 2.5 * direction();
        const Vector3d u = direction();
        const Vector3d v = 0.8 * u.cross(direction());
        const Surface other = k % 2 == 0 ? disc(there, direction(), 0.6) : wall_at(there - (u + v) / 2, u, v);
        const double area = disc_exchange(one, other);
        if (area < 0) continue;
        ++found;
        EXPECT_NEAR(area, by_quadrature(one, other), 1e-9) << k;
        EXPECT_NEAR(area, disc_exchange(other, one), 1e-13) << k;
    }
    EXPECT_EQ(found, 20);
}

TEST(DiscExchange, StatesAnErrorThatHolds) {
    for (const double offset : {0.0, 0.3, 0.9, 1.4}) {
        for (const double height : {0.02, 0.1, 1.0, 30.0}) {
            const Surface one = disc({0, 0, 0}, {0, 0, 1}, 1);
            const Surface other = disc({offset, 0, height}, {0, 0.1 * height, -1}, 0.3);
            const auto best = disc_exchange_area(one, other, 1e-14);
            if (!best) continue;
            for (const double wanted : {1e-2, 1e-4, 1e-7}) {
                const auto rough = disc_exchange_area(one, other, wanted);
                ASSERT_TRUE(rough);
                EXPECT_LE(rough->error, wanted);
                EXPECT_LE(std::abs(rough->value - best->value), rough->error + best->error) << offset << " " << height;
            }
        }
    }
}

TEST(DiscExchange, IsEmptyWhereItIsNotKnown) {
    const Surface floor = wall_at({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
    EXPECT_FALSE(disc_exchange_area(disc({0, 0, 0.1}, {0, 1, 0}, 0.2), floor, 1e-9)) << "partly behind";
    EXPECT_FALSE(
        disc_exchange_area(disc({0, 0.1, 0.2}, {0, 1, 0}, 0.2), wall_at({-1, 0.1, 0}, {0, 0, 2}, {2, 0, 0}), 1e-9))
        << "level";
    EXPECT_FALSE(
        disc_exchange_area(disc({0, 0, 1}, {0, 0, -1}, 0.2), test::sphere({0, 0, 0}, 0.2, Facing::outward), 1e-9));
}

}  // namespace
}  // namespace ff
