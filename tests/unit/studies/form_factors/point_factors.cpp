#include "studies/form_factors/point_factors.hpp"

#include "core/configurations/built_in_scene.hpp"
#include "core/support/error.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ff::studies::form_factors {
namespace {

using Eigen::Vector3d;

Request finely() {
    Request request;
    request.tolerance = 1e-7;
    return request;
}

/// From an element of area that faces a corner of a rectangle a x b at a distance of 1, parallel to it [howell].
double to_corner(double a, double b) {
    const double x = std::sqrt(1 + a * a), y = std::sqrt(1 + b * b);
    return (a / x * std::atan(b / x) + b / y * std::atan(a / y)) / (2 * std::numbers::pi);
}

TEST(PointFactors, MatchTheFormula) {
    const Scene scene = built_in_scene("box:2x3x1");  // of which the sixth face lies opposite the fifth
    for (const double x : {1e-3, 0.3, 1.0, 1.9}) {
        for (const double y : {0.1, 1.5, 2.99}) {
            const auto factors = PointFactors(scene).from({x, y, 0}, {0, 0, 2});
            const double wanted = to_corner(x, y) + to_corner(2 - x, y) + to_corner(x, 3 - y) + to_corner(2 - x, 3 - y);
            double sum = 0;
            bool is_there = false;
            for (const PointFactor& factor : factors) {
                EXPECT_LE(factor.low, factor.value);
                EXPECT_LE(factor.value, factor.high);
                EXPECT_LT(factor.high - factor.low, 1e-11);
                is_there = is_there || (factor.low <= wanted && wanted <= factor.high);
                sum += factor.value;
            }
            EXPECT_TRUE(is_there) << x << ' ' << y;
            EXPECT_NEAR(sum, 1, 1e-11);
        }
    }
}

// The mean over a face is the form factor, past what stands in between as well.
TEST(PointFactors, HaveTheFormFactorAsTheirMean) {
    const Scene scene = built_in_scene("nested_cubes");
    const Matrix matrix = find_matrix(scene, finely());
    const PointFactors finder(scene);
    const auto& wall = std::get<Parallelogram>(scene.surfaces[0].shape);
    std::vector<double> means(scene.faces.size());
    constexpr int side = 60;
    for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j) {
            const Vector3d place = wall.corner + (i + 0.5) / side * wall.edge_u + (j + 0.5) / side * wall.edge_v;
            const auto factors = finder.from(place, scene.surfaces[0].normal);
            for (std::size_t face = 0; face < means.size(); ++face) means[face] += factors[face].value / (side * side);
        }
    }
    const auto from = static_cast<std::size_t>(scene.surfaces[0].face);
    double sum = 0;
    for (std::size_t face = 0; face < means.size(); ++face) {
        EXPECT_NEAR(means[face], matrix.exchange(from, face).value / matrix.areas[from], 3e-4);
        sum += means[face];
    }
    EXPECT_NEAR(sum, 1, 1e-10);
}

// Far from the origin, beside a thin plate, on a surface, behind everything.
TEST(PointFactors, HoldWhereverThePointIs) {
    const std::string plates =
        "v 1000000 0 0\nv 1000001 0 0\nv 1000001 1 0\nv 1000000 1 0\nv 1000000 0 1\nv 1000001 0 1\nv 1000001 1 1\n"
        "v 1000000 1 1\ng low\nf 1 2 3 4\ng front\nf 5 8 7 6\ng back\nf 6 7 8 5\n";
    const Scene scene = make_scene(source_of_file("a.obj", plates));
    const PointFactors finder(scene);
    const double centre = 4 * to_corner(0.5, 0.5);
    const auto up = finder.from({1000000.5, 0.5, 0}, {0, 0, 1});
    EXPECT_NEAR(up[1].value, centre, 1e-12);
    EXPECT_EQ(up[0].high, 0);
    EXPECT_EQ(up[2].high, 0);
    const auto down = finder.from({1000000.5, 0.5, 2}, {0, 0, -1});
    EXPECT_NEAR(down[2].value, centre, 1e-12);
    EXPECT_EQ(down[0].value, 0) << "the plate hides it";
    for (const PointFactor& factor : finder.from({1000000.5, 0.5, 2}, {0, 0, 1})) EXPECT_EQ(factor.high, 0);
}

// Near to a wall in a room whose coordinates have few digits, and with a normal of any length.
TEST(PointFactors, SeeANearFaceWhole) {
    const std::string room =
        "# closed\nv 0 0 0\nv 116.123 0 0\nv 116.123 104.237 0\nv 0 104.237 0\nv 0 0 103.519\nv 116.123 0 103.519\n"
        "v 116.123 104.237 103.519\nv 0 104.237 103.519\ng floor\nf 1 2 3 4\ng roof\nf 5 8 7 6\ng south\nf 1 5 6 2\n"
        "g east\nf 2 6 7 3\ng north\nf 3 7 8 4\ng west\nf 4 8 5 1\n";
    const PointFactors finder(make_scene(source_of_file("a.obj", room)));
    for (const double length : {1e-200, 1.0, 1e300})
        EXPECT_GT(finder.from({50, 0.005, 50}, {0, -length, 0})[2].value, 0.999999) << length;
}

TEST(PointFactors, AreRefusedForCurvedSurfaces) {
    EXPECT_THROW(PointFactors(built_in_scene("coaxial_discs")), UserError);
}

}  // namespace
}  // namespace ff::studies::form_factors
