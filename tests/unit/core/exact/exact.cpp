#include "core/exact/exact.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"
#include "tests/unit/core/geometry/rectangles.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace ff {
namespace {

using test::rectangle;
using test::same_exchange_area;
using test::scene_of;

struct Reference {
    std::string name;
    Surface from;
    Surface to;
    double form_factor = 0;
};

std::vector<Reference> read_references() {
    std::ifstream file(FF_TEST_DATA "/reference_rectangles.csv");
    std::vector<Reference> references;
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
        std::istringstream cells(line);
        std::array<std::string, 5> cell;
        for (std::string& text : cell) {
            std::getline(cells, text, ',');
        }
        references.push_back({cell[0] + ", " + cell[1], rectangle(cell[2]), rectangle(cell[3]), std::stod(cell[4])});
    }
    return references;
}

TEST(ExactExchangeArea, AgreesWithContourIntegralsAndHowellsCatalogue) {
    const auto references = read_references();
    ASSERT_EQ(references.size(), 17u);
    for (const auto& [name, from, to, form_factor] : references) {
        const auto exchange = exact_exchange_area(from, to);
        ASSERT_TRUE(exchange) << name;
        EXPECT_TRUE(same_exchange_area(*exchange, form_factor * area(from.shape), test::squared_extent(from, to)))
            << name;
    }
}

TEST(ExactFormFactor, IsRightToTheLastDigitsUnlessFacesAreFarApart) {
    for (const auto& [name, from, to, form_factor] : read_references()) {
        const double rounding = 2.3e-16 * form_factor;
        const double allowed = 1e-18 * test::squared_extent(from, to) / area(from.shape) + rounding;
        EXPECT_NEAR(exact_form_factor(scene_of({from, to}), 0, 1).value(), form_factor, allowed) << name;
    }
}

TEST(ExactExchangeArea, IsZeroWhereRectanglesDoNotFaceEachOther) {
    const Surface floor = rectangle("0:1 0:1 0:0 +z");
    const std::array hidden{
        rectangle("0:1 0:1 1:1 +z"),    // looks away
        rectangle("0:1 0:1 -1:-1 +z"),  // below, looks at the floor's back
        rectangle("0:1 0:1 -1:-1 -z"),  // below, looks away
        rectangle("1:2 0:1 0:0 +z"),    // in the same plane
        rectangle("0:1 0:1 0:0 -z"),    // its back
        rectangle("0:1 0:0 -1:0 +y"),   // a wall below the floor
        rectangle("0:1 1:1 0:1 +y"),    // a wall that looks away
        rectangle("0:1 2:2 0.5:1 +y"),  // the same, without a common edge
    };
    for (const Surface& other : hidden) {
        EXPECT_EQ(exact_exchange_area(floor, other), 0.0);
        EXPECT_EQ(exact_exchange_area(other, floor), 0.0);
    }
    EXPECT_EQ(exact_exchange_area(floor, floor), 0.0);
}

TEST(ExactExchangeArea, CountsOnlyThePartInFront) {
    const Surface floor = rectangle("0:2 -1:3 0:0 +z");
    const Surface front = rectangle("0:2 0:3 0:0 +z");
    const Surface wall = rectangle("0.5:1 0:0 -2:1 +y");
    const Surface above = rectangle("0.5:1 0:0 0:1 +y");
    EXPECT_EQ(exact_exchange_area(floor, wall), exact_exchange_area(front, above));
    EXPECT_GT(exact_exchange_area(floor, wall).value(), 0.05);
}

TEST(ExactExchangeArea, StaysInRangeForTinyHugeFarAndNearRectangles) {
    const Surface floor = rectangle("0:1 0:1 0:0 +z");
    const Surface ceiling = rectangle("0:1 0:1 1:1 -z");
    const double unit = exact_exchange_area(floor, ceiling).value();
    for (const int power : {-200, -30, 30, 200}) {
        const double size = std::ldexp(1.0, power);
        EXPECT_EQ(exact_exchange_area(test::scaled(floor, size), test::scaled(ceiling, size)), unit * size * size);
    }
    // A gap of 1e-14: everything that leaves the floor arrives.
    EXPECT_NEAR(exact_exchange_area(floor, rectangle("0:1 0:1 1e-14:1e-14 -z")).value(), 1, 3e-14);
    // 1e6 away: the point-to-point limit 1/(pi r^2) = 3.2e-13, and the absolute error is 1e-15 * 1e12.
    EXPECT_NEAR(exact_exchange_area(floor, rectangle("0:1 0:1 1e6:1e6 -z")).value(), 1e-12 / std::numbers::pi, 1e-3);
    // 1e8 from the origin every coordinate is still exact here.
    const Eigen::Vector3d far(1e8, -1e8, 1e8);
    EXPECT_EQ(exact_exchange_area(test::translated(floor, far), test::translated(ceiling, far)), unit);
}

TEST(ExactExchangeArea, DoesNotDependOnHowTheEdgesAreDirected) {
    const Surface floor = rectangle("0:1 0:2 0:0 +z");
    const Surface wall = rectangle("0:1 0:0 0:3 +y");
    Surface turned = wall;
    parallelogram(turned).corner += parallelogram(turned).edge_u;
    parallelogram(turned).edge_u *= -1;
    std::swap(parallelogram(turned).edge_u, parallelogram(turned).edge_v);
    EXPECT_EQ(exact_exchange_area(floor, turned), exact_exchange_area(floor, wall));
}

TEST(ExactExchangeArea, IsEmptyWhereNoElementaryFormulaApplies) {
    const Surface floor = rectangle("0:1 0:1 0:0 +z");
    Surface tilted = rectangle("0:1 0:1 1:1 -z");
    parallelogram(tilted).edge_v = {0, 1, 0.5};
    tilted.normal = Eigen::Vector3d(0, 0.5, -1).normalized();
    EXPECT_FALSE(exact_exchange_area(floor, tilted));
    EXPECT_FALSE(exact_exchange_area(tilted, floor));

    const Scene scene = scene_of({floor, tilted});
    EXPECT_FALSE(exact_form_factor(scene, 0, 1));
    EXPECT_FALSE(exact_form_factors(scene));
    EXPECT_FALSE(exact_patch_to_face(scene, {2}));
}

TEST(ExactFormFactors, MatchHowellsCatalogueForTheCube) {
    const auto factors = exact_form_factors(built_in_scene("cube")).value();
    constexpr std::array opposite{5, 2, 1, 4, 3, 0};
    for (int from = 0; from < 6; ++from) {
        for (int to = 0; to < 6; ++to) {
            const double expected = from == to                                       ? 0
                                    : to == opposite[static_cast<std::size_t>(from)] ? 0.199824895698387383
                                                                                     : 0.200043776075403154;
            EXPECT_DOUBLE_EQ(factors(from, to), expected) << from << " to " << to;
        }
    }
}

TEST(ExactFormFactor, SumsOverTheSurfacesOfAFace) {
    // The floor of a cube in two unequal pieces is still its floor.
    Scene scene = make_box(1, 1, 1);
    parallelogram(scene.surfaces[0]).edge_u *= 0.25;
    scene.surfaces.push_back({Parallelogram{{0.25, 0, 0}, {0.75, 0, 0}, {0, 1, 0}}, {0, 0, 1}, 0});
    EXPECT_DOUBLE_EQ(exact_form_factor(scene, 0, 5).value(), 0.199824895698387383);
    EXPECT_DOUBLE_EQ(exact_form_factor(scene, 1, 0).value(), 0.200043776075403154);
    EXPECT_DOUBLE_EQ(exact_patch_to_face(scene, {1}).value()(5, 0), 0.199824895698387383);
}

TEST(ExactPatchToFace, HasTheSymmetryOfTheCube) {
    const auto factors = exact_patch_to_face(built_in_scene("cube"), {3}).value();
    ASSERT_EQ(factors.rows(), 54);
    ASSERT_EQ(factors.cols(), 6);
    // Patch 1 of face 1 lies at its frontal edge (y = 0, face 3), in the middle of x; patch 4 is the centre.
    EXPECT_DOUBLE_EQ(factors(1, 3), factors(1, 4));
    EXPECT_GT(factors(1, 2), 2 * factors(1, 1));
    EXPECT_DOUBLE_EQ(factors(4, 1), factors(4, 2));
    EXPECT_DOUBLE_EQ(factors(4, 2), factors(4, 3));
    EXPECT_GT(factors(4, 5), factors(1, 5));
}

}  // namespace
}  // namespace ff
