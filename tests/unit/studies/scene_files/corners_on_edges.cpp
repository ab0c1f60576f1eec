// Corners that lie on an edge of their polygon but for the rounding of coordinates, and rows of rooms whose corners do
// not quite meet.

#include "core/geometry/scene.hpp"
#include "core/geometry/surface_map.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "studies/heat/factor_intervals.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <fmt/format.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ff::studies {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A closed room of 4 x 3 x 2.5, turned around the vertical. Its floor and south wall share a fifth corner on their
/// edge.
std::string room_with_corner_on_edge(double degrees, int decimals) {
    const double angle = degrees * std::numbers::pi / 180;
    std::string text = "# closed\n";
    const std::array<std::array<double, 3>, 9> corners{
        {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}, {0, 0, 2.5}, {4, 0, 2.5}, {4, 3, 2.5}, {0, 3, 2.5}, {1.3, 0, 0}}};
    for (const auto& [x, y, z] : corners)
        text += fmt::format("v {:.{}f} {:.{}f} {}\n", x * std::cos(angle) - y * std::sin(angle), decimals,
                            x * std::sin(angle) + y * std::cos(angle), decimals, z);
    return text +
           "g floor\nf 1 9 2 3 4\ng roof\nf 5 8 7 6\ng south\nf 1 5 6 2 9\ng east\nf 2 6 7 3\ng north\nf 3 7 8 4\n"
           "g west\nf 4 8 5 1\n";
}

double factor(const Scene& scene, std::size_t from, std::size_t to) {
    const auto matrix = form_factors::find_matrix(scene, {});
    EXPECT_TRUE(form_factors::is_trusted(scene, matrix, 1e-5));
    return matrix.exchange(from, to).value / matrix.areas[from];
}

/// In a room whose first faces are its floor and its roof.
double floor_to_roof(const Scene& scene) {
    return factor(scene, 0, 1);
}

/// Of a box, whose faces have other numbers.
double floor_to_roof_of_box(std::string_view title) {
    return factor(make_scene(title), 0, 5);
}

TEST(CornersOnEdges, OpenNoHoleWhereTheyAreRounded) {
    const double exact = floor_to_roof_of_box("box:4x3x2.5");
    for (const double degrees : {5.0, 17.0, 30.0, 45.0}) {
        for (const int decimals : {6, 7, 8, 9, 10, 12}) {
            const Scene scene = make_scene(source_of_file("a.obj", room_with_corner_on_edge(degrees, decimals)));
            const SceneDoubts doubts = examine_scene(scene);
            EXPECT_THAT(doubts.faults, IsEmpty()) << degrees << " " << decimals;
            EXPECT_THAT(doubts.notes, IsEmpty()) << degrees << " " << decimals;
            EXPECT_NEAR(floor_to_roof(scene), exact, std::pow(10, -decimals)) << degrees << " " << decimals;
        }
    }
}

TEST(CornersOnEdges, ArePartsOfTheOutlineWhereNothingIsRounded) {
    // The floor has a notch, which the wall's fifth corner fills: 5e-10 of the floor's area.
    const std::string text =
        "# closed\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nv .5 1e-9 0\n"
        "g floor\nf 1 9 2 3 4\ng roof\nf 5 8 7 6\ng south\nf 1 5 6 2 9\ng east\nf 2 6 7 3\ng north\nf 3 7 8 4\n"
        "g west\nf 4 8 5 1\n";
    const Scene scene = make_scene(source_of_file("a.obj", text));
    EXPECT_THAT(examine_scene(scene).faults, IsEmpty());
    EXPECT_NEAR(floor_to_roof(scene), floor_to_roof_of_box("box:1x1x1"), 1e-8);
}

TEST(CornersOnEdges, TakeNoAreaFromStripsOfThinTriangles) {
    // Strips of 0.02, at coordinates of seven digits that are rounded to 0.01, beside a square of the same face.
    std::string text = "g floor\n";
    std::size_t corners = 0;
    const auto add = [&](double x, double width) {
        for (const auto& [dx, dy] :
             {std::pair(0.0, 0.0), std::pair(width, 0.0), std::pair(width, 1.0), std::pair(0.0, 1.0)})
            text += fmt::format("v {:.2f} {:.2f} 0\n", 10000.12 + x + dx, 10000.37 + dy);
        const auto n = corners;
        corners += 4;
        return n;
    };
    const std::size_t square = add(0, 1);
    text += fmt::format("f {} {} {} {}\n", square + 1, square + 2, square + 3, square + 4);
    for (int strip = 0; strip < 50; ++strip) {
        const std::size_t n = add(1 + 0.02 * strip, 0.02);
        text += fmt::format("f {0} {1} {2}\nf {0} {2} {3}\n", n + 1, n + 2, n + 3, n + 4);
    }
    EXPECT_NEAR(face_area(make_scene(source_of_file("a.obj", text)), 0), 2, 1e-6);
}

TEST(CornersOnEdges, OpenNoHoleWhereTheyBendANeighbour) {
    // An attic whose floor and sides share a corner on each eave: rounding bends the sides, whose slivers then lie on
    // those of the floor.
    std::string text = "# closed\n";
    for (const auto& [x, y, z] : std::vector<std::array<double, 3>>{
             {0, 0, 0}, {8, 0, 0}, {8, 6, 0}, {0, 6, 0}, {0, 3, 2}, {8, 3, 2}, {3.3, 0, 0}, {4.7, 6, 0}}) {
        const double angle = 0.3;
        text += fmt::format("v {:.3f} {:.3f} {:.3f}\n", x * std::cos(angle) - y * std::sin(angle),
                            x * std::sin(angle) + y * std::cos(angle), z);
    }
    text += "g floor\nf 1 7 2 3 8 4\ng south\nf 1 5 6 2 7\ng north\nf 3 6 5 4 8\ng east\nf 2 6 3\ng west\nf 4 5 1\n";
    const Scene scene = make_scene(source_of_file("a.obj", text));
    EXPECT_THAT(examine_scene(scene).faults, IsEmpty());
    form_factors::Request request;
    request.tolerance = 1e-3;
    EXPECT_TRUE(form_factors::is_trusted(scene, form_factors::find_matrix(scene, request), request.tolerance));
}

/// A room of 60 x 40 x 10 whose roof is too narrow by a gap along one wall.
std::string room_with_gap(double gap) {
    return fmt::format(
        "C encl=1\nF 3\nV 1 0 0 0\nV 2 60 0 0\nV 3 60 40 0\nV 4 0 40 0\nV 5 0 0 10\nV 6 60 0 10\nV 7 60 40 10\n"
        "V 8 0 40 10\nV 9 {0} 0 10\nV 10 {0} 40 10\nS 1 1 2 3 4 0 0 .9 floor\nS 2 9 10 7 6 0 0 .9 roof\n"
        "S 3 1 5 6 2 0 0 .9 south\nS 4 2 6 7 3 0 0 .9 east\nS 5 3 7 8 4 0 0 .9 north\nS 6 4 8 5 1 0 0 .9 west\n",
        gap);
}

TEST(Gaps, BelowTheToleranceLetEntriesOfARowAddUpToOne) {
    const Scene scene = make_scene(source_of_file("a.vs3", room_with_gap(0.01)));
    for (const double tolerance : {1e-3, 1e-2}) {
        form_factors::Request request;
        request.tolerance = tolerance;
        const auto matrix = form_factors::find_matrix(scene, request);
        EXPECT_TRUE(form_factors::is_trusted(scene, matrix, tolerance));
        EXPECT_GT(matrix.leak, 1e-5);
        const FactorBounds bounds = heat::possible_factors(scene, matrix).bounds;
        for (Eigen::Index row = 0; row < bounds.low.rows(); ++row) EXPECT_TRUE(can_add_up(bounds, row)) << row;
    }
    EXPECT_FALSE(form_factors::is_trusted(scene, form_factors::find_matrix(scene, {}), 1e-5));
}

}  // namespace
}  // namespace ff::studies
