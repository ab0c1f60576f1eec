// Rooms whose faces see themselves, or each other by way of mirrors: exact factors against other derivations, and rays
// that are traced there against exact factors.

#include "core/configurations/built_in_scene.hpp"
#include "core/estimators/rays/ray_shooting.hpp"
#include "core/exact/exact.hpp"
#include "core/exact/known_factors.hpp"
#include "core/radiosity/enclosures.hpp"
#include "core/radiosity/patch_factors.hpp"
#include "core/radiosity/system.hpp"
#include "core/support/error.hpp"
#include "core/visibility/facing.hpp"
#include "core/visibility/mirrors.hpp"
#include "tests/support/philox_points.hpp"
#include "tests/support/round_scenes.hpp"
#include "tests/support/statistical_assertions.hpp"
#include "tests/support/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace ff {
namespace {

using std::numbers::pi;
using test::somewhere;
using test::tilted;

Scene cylinder(double radius, double height) {
    return test::faces_of(
        {test::disc(somewhere, tilted, radius), test::disc(somewhere + height * tilted, -tilted, radius),
         test::wall(somewhere, height * tilted, radius, radius, Facing::inward)},
        true);
}

/// A spherical cap of this height and the disc that closes it, from below.
Scene cap(double radius, double height) {
    const double low = 1 - height / radius;
    return test::faces_of({test::sphere(somewhere, radius, Facing::inward, low, 1),
                           test::disc(somewhere + low * radius * tilted, tilted, radius * std::sqrt(1 - low * low))},
                          true);
}

Scene cone(double radius, double height) {
    return test::faces_of(
        {test::wall(somewhere, height * tilted, radius, 0, Facing::inward), test::disc(somewhere, tilted, radius)},
        true);
}

/// The cylinder and the cone as a silo, its floor and its wall in two pieces: all factors follow from closure with
/// what is behind a disc.
Scene silo() {
    return test::faces_of({test::disc(somewhere, tilted, 1), test::disc(somewhere, tilted, 2, 1),
                           test::wall(somewhere + 3 * tilted, -2 * tilted, 2, 2, Facing::inward),
                           test::wall(somewhere, tilted, 2, 2, Facing::inward),
                           test::wall(somewhere + 3 * tilted, tilted, 2, 0.5, Facing::inward),
                           test::disc(somewhere + 4 * tilted, -tilted, 0.5)},
                          true);
}

Scene spheres() {
    return test::faces_of({test::sphere(somewhere, 2, Facing::inward),
                           test::sphere(somewhere + Eigen::Vector3d(0.4, 0, 0), 1, Facing::outward)},
                          true);
}

Scene mirrored(const char* box, std::vector<std::string> mirrors) {
    return with_mirrors(built_in_scene(box), mirrors);
}

/// A wedge-shaped room: no wall of it but the ends is opposite another.
Scene wedge() {
    const Eigen::Vector3d a(0, 0, 0), b(2, 0, 0), c(0, 1, 0), z(0, 0, 1.5);
    const auto quad = [](const Eigen::Vector3d& corner, const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
        return Surface{Parallelogram{corner, u, v}, u.cross(v).normalized(), 0};
    };
    const auto triangle = [](const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r) {
        return Surface{Triangle{p, q, r}, (q - p).cross(r - p).normalized(), 0};
    };
    return test::faces_of(
        {triangle(a, b, c), triangle(a + z, c + z, b + z), quad(a, z, b - a), quad(a, c - a, z), quad(b, z, c - b)},
        true);
}

Eigen::VectorXd areas_of(const Scene& scene) {
    Eigen::VectorXd areas(static_cast<Eigen::Index>(scene.faces.size()));
    for (Eigen::Index i = 0; i < areas.size(); ++i) areas[i] = face_area(scene, static_cast<int>(i));
    return areas;
}

std::vector<Scene> all_rooms() {
    return {cylinder(1, 2),
            cap(1, 0.5),
            cap(1, 1.7),
            cone(1, 1),
            silo(),
            spheres(),
            wedge(),
            mirrored("cube", {"6"}),
            mirrored("box:2x1x0.5", {"1", "3"}),
            mirrored("box:2x1x0.5", {"5", "2", "6"})};
}

constexpr double rounding_in_rooms = 4e-15;

TEST(ExactRooms, AgreeWithIndependentlyDerivedEnclosures) {
    EXPECT_LT((*exact_room_factors(cylinder(1, 2)) - closed_cylinder(1, 2).factors).norm(), rounding_in_rooms);
    EXPECT_LT((*exact_room_factors(cylinder(3, 0.1)) - closed_cylinder(3, 0.1).factors).norm(), 1e-13);
    EXPECT_LT((*exact_room_factors(cap(1, 0.5)) - cavity(pi, pi * 0.75).factors).norm(), rounding_in_rooms);
    EXPECT_LT((*exact_room_factors(cone(1, 1)) - cavity(pi * std::sqrt(2.0), pi).factors).norm(), rounding_in_rooms);
    EXPECT_LT((*exact_room_factors(spheres()) - cavity(4, 1).factors).norm(), rounding_in_rooms);
}

TEST(ExactRooms, AreClosedAndReciprocal) {
    for (const Scene& scene : all_rooms()) {
        const auto factors = exact_room_factors(scene);
        ASSERT_TRUE(factors) << scene.canonical;
        const FactorProperties properties = factor_properties(*factors, areas_of(scene));
        EXPECT_LT(properties.closure_defect, 2e-14) << scene.canonical;
        EXPECT_LT(properties.reciprocity_defect, 2e-14) << scene.canonical;
        EXPECT_GE(factors->minCoeff(), 0);
        for (int face = 0; face < factors->rows(); ++face)
            EXPECT_EQ((*factors)(face, face) > 1e-12, sees_itself(scene, face)) << scene.canonical << " " << face;
    }
}

// Two mirrors that meet continue the box along both axes: a quarter of a box of twice the length and width.
TEST(MirrorsThatMeet, MakeAQuarterOfALargerBox) {
    const Scene quarter = mirrored("box:2x1x0.5", {"4", "3"});  // x = 0 and y = 0
    const Eigen::MatrixXd whole = exact_form_factors(built_in_scene("box:4x2x0.5")).value();
    const Eigen::MatrixXd factors = exact_room_factors(quarter).value();
    // The remaining faces are z = 0, y = b, x = a, z = c; every face of the larger box is seen whole.
    const std::vector<std::vector<int>> seen{{0}, {1, 2}, {3, 4}, {5}};
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            double sum = 0;
            for (const int to : seen[static_cast<std::size_t>(j)])
                sum += whole(seen[static_cast<std::size_t>(i)].front(), to);
            EXPECT_NEAR(factors(i, j), sum, rounding_in_rooms) << i << " " << j;
        }
    }
}

/// Hits by pair of faces, of independent rays from every patch.
RayTally tally_of_rays(const Scene& scene, TracerChoice choice, std::uint64_t rays) {
    RayTally tally;
    PatchSums sums;
    const Subdivision divided{2};
    ray_shooting(scene, divided, *make_tracer(scene, choice), test::PhiloxPoints(rays), rays, Allocation::patch, {3, 4},
                 1, tally, &sums);
    return tally;
}

// Every pair of faces of every room: about 200 exact binomial tests of 1e-7 each. A mirror that absorbs, or turns rays
// the wrong way round, changes factors by 0.02 and more.
TEST(TracedRooms, AreUnbiased) {
    for (const Scene& scene : all_rooms()) {
        const Eigen::MatrixXd exact = exact_room_factors(scene).value();
        const auto tally = tally_of_rays(scene, TracerChoice::automatic, 20000);
        const std::size_t faces = scene.faces.size();
        for (std::size_t i = 0; i < faces; ++i) {
            EXPECT_EQ(tally.lost[i], 0u) << scene.canonical;
            for (std::size_t j = 0; j < faces; ++j) {
                const double p = exact(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
                const std::uint64_t hits = tally.hits[i * faces + j];
                if (p < 1e-12) {
                    EXPECT_EQ(hits, 0u) << scene.canonical << " " << i << " " << j;
                } else if (p < 1 - 1e-12) {
                    EXPECT_TRUE(test::has_probability(hits, tally.rays[i], p, {.alpha = 1e-7, .detects = 0.02}))
                        << scene.canonical << " " << i << " " << j;
                }
            }
        }
    }
}

TEST(TracedMirrors, AgreeBetweenBothTracersExceptAtEdges) {
    const Scene scene = mirrored("box:2x1x0.5", {"1", "3"});
    const auto box = tally_of_rays(scene, TracerChoice::box, 5000);
    const auto embree = tally_of_rays(scene, TracerChoice::embree, 5000);
    for (std::size_t pair = 0; pair < box.hits.size(); ++pair)
        EXPECT_NEAR(static_cast<double>(box.hits[pair]), static_cast<double>(embree.hits[pair]), 3);
}

// From patch to patch by way of the mirrors: 24 exact binomial tests of 1e-7.
TEST(TracedMirrors, ShowPatchesWhereTheirImagesAre) {
    const Scene scene = mirrored("box:2x1x0.5", {"1", "3"});
    const Subdivision divided{3};
    const Eigen::MatrixXd exact = exact_patch_factors(scene, divided).value();
    const FactorProperties properties = factor_properties(exact, patch_areas(scene, divided));
    ASSERT_EQ(exact.rows(), 36);
    EXPECT_LT(properties.closure_defect, 1e-11);
    EXPECT_LT(properties.reciprocity_defect, 1e-14);
    EXPECT_TRUE(((exact.array() > 1e-12) == patch_sight(scene, divided)).all());
    const std::uint64_t rays = 20000;
    const Eigen::MatrixXd factors = shoot_patch_factors(scene, divided, *make_tracer(scene, TracerChoice::automatic),
                                                        test::PhiloxPoints(rays), rays, Allocation::patch, {1, 2}, 5);
    for (Eigen::Index patch = 0; patch < exact.rows(); ++patch) {
        EXPECT_NEAR(factors.row(patch).sum(), 1, 1e-12);
        Eigen::Index to = 0;
        exact.row(patch).maxCoeff(&to);
        const auto hits = static_cast<std::uint64_t>(std::llround(factors(patch, to) * static_cast<double>(rays)));
        EXPECT_TRUE(test::has_probability(hits, rays, exact(patch, to), {.alpha = 1e-7, .detects = 0.04})) << patch;
    }
}

// A cylinder whose top is a mirror is half of one of twice the height. Hidden or bent images are not computed, so that
// there is no exact value, but rays find it: three binomial tests of 1e-7.
TEST(TracedMirrors, AreFlatShapesOfAnyKind) {
    const std::vector<std::string> top{"2"};
    const Scene half = with_mirrors(cylinder(1, 1), top);
    EXPECT_FALSE(exact_room_factors(half));
    const Eigen::MatrixXd whole = closed_cylinder(1, 2).factors;
    const auto tally = tally_of_rays(half, TracerChoice::automatic, 20000);
    const auto expect = [&](std::size_t i, std::size_t j, double p) {
        EXPECT_TRUE(test::has_probability(tally.hits[i * 2 + j], tally.rays[i], p, {.alpha = 1e-7, .detects = 0.02}));
    };
    expect(0, 0, whole(0, 1));
    expect(0, 1, whole(0, 2));
    expect(1, 1, whole(2, 2));
}

// Between opposite mirrors rays may be reflected forever: those that have been reflected 64 times are lost, and they
// are few.
TEST(TracedMirrors, LoseEndlessRays) {
    const Scene scene = mirrored("cube", {"1", "6"});
    EXPECT_FALSE(exact_room_factors(scene));
    const auto tally = tally_of_rays(scene, TracerChoice::automatic, 20000);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_LE(tally.lost[i], 8u);
}

TEST(RoomsWithoutExactFactors, AreReported) {
    Scene open = cylinder(1, 2);
    open.closed = false;
    EXPECT_FALSE(exact_room_factors(open));
    Scene bulging =
        test::faces_of({test::wall(somewhere, tilted, 1, 2, Facing::inward),  // a room with a waist is not convex
                        test::wall(somewhere - tilted, tilted, 2, 1, Facing::inward),
                        test::disc(somewhere - tilted, tilted, 2), test::disc(somewhere + tilted, -tilted, 2)},
                       true);
    EXPECT_FALSE(exact_room_factors(bulging));
    Scene apart = cylinder(1, 2);
    std::get<Disc>(apart.surfaces[0].shape).outer_radius = 0.9;
    EXPECT_FALSE(exact_room_factors(apart)) << "a gap along the rim";
    Scene askew = cylinder(1, 2);
    std::get<Disc>(askew.surfaces[0].shape).centre += Eigen::Vector3d(0.1, 0, 0);
    EXPECT_FALSE(exact_room_factors(askew));
    Scene outward = cylinder(1, 2);
    std::get<Frustum>(outward.surfaces[2].shape).facing = Facing::outward;
    EXPECT_FALSE(exact_room_factors(outward));
}

TEST(Mirrors, AreRefusedWhereTheyAreImpossible) {
    const auto message = [](const Scene& scene, std::vector<std::string> mirrors) {
        return test::message_of<UserError>([&] { static_cast<void>(with_mirrors(scene, mirrors)); });
    };
    EXPECT_THAT(message(built_in_scene("cube"), {"7"}), testing::HasSubstr("has no face '7'"));
    EXPECT_THAT(message(cylinder(1, 2), {"3"}), testing::HasSubstr("is curved"));
    EXPECT_THAT(message(cap(1, 1), {"1", "2"}), testing::HasSubstr("every face"));
    const Scene scene = mirrored("cube", {"2", "1"});
    EXPECT_EQ(scene.faces, (std::vector<std::string>{"3", "4", "5", "6"}));
    EXPECT_EQ(scene.canonical, mirrored("cube", {"1", "2"}).canonical);
}

}  // namespace
}  // namespace ff
