// Surfaces of a face that meet in an edge or a circle and face opposite ways: they are turned round where it is clear
// which is meant, and a fault otherwise, also where rounding has moved corners apart.

#include "core/geometry/surface_map.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies {
namespace {

using Eigen::Vector3d;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Winding, IsAFaultWhereSurfacesOfATomlFaceDisagree) {
    constexpr std::string_view half = "[[surface]]\nface = '{}'\nshape = 'triangle'\na = [0, 0, {}]\nb = {}\nc = {}\n";
    const auto scene_of = [&](std::string_view second, std::string_view third) {
        return make_scene(
            source_of_file("a.toml", fmt::format(fmt::runtime(half), "floor", 0, "[1, 0, 0]", "[1, 1, 0]") +
                                         fmt::format(fmt::runtime(half), "floor", 0, second, third) +
                                         fmt::format(fmt::runtime(half), "roof", 1, "[0, 1, 1]", "[1, 1, 1]")));
    };
    EXPECT_THAT(examine_scene(scene_of("[1, 1, 0]", "[0, 1, 0]")).faults, IsEmpty());
    EXPECT_THAT(examine_scene(scene_of("[0, 1, 0]", "[1, 1, 0]")).faults,
                ElementsAre(HasSubstr("surfaces of face 'floor' meet in an edge and face opposite ways")));
}

TEST(Winding, IsAFaultWhereRoundSurfacesOfATomlFaceDisagree) {
    constexpr std::string_view tank =
        "[[surface]]\nface = 'tank'\nshape = 'cylinder'\nbase = [0, 0, 0]\naxis = [0, 0, 2]\nradius = 1\n"
        "facing = 'inward'\n[[surface]]\nface = '{}'\nshape = 'disc'\ncentre = [0, 0, 2]\nnormal = [0, 0, {}]\n"
        "radius = 1\n";
    constexpr std::string_view ball =
        "[[surface]]\nface = 'ball'\nshape = 'sphere'\ncentre = [0, 0, 0]\nradius = 1\naxis = [0, 0, 1]\n"
        "low = 0\nfacing = 'outward'\n[[surface]]\nface = 'ball'\nshape = 'sphere'\ncentre = [0, 0, 0]\nradius = 1\n"
        "axis = [0, 0, {}]\n{} = 0\nfacing = '{}'\n";
    const auto doubts_of = [](const std::string& text) {
        return examine_scene(make_scene(source_of_file("a.toml", text)));
    };
    const auto disagree = [](std::string_view face) {
        return ElementsAre(
            HasSubstr(fmt::format("surfaces of face '{}' meet in an edge and face opposite ways", face)));
    };
    EXPECT_THAT(doubts_of(fmt::format(tank, "tank", -1)).faults, IsEmpty());
    EXPECT_THAT(doubts_of(fmt::format(tank, "tank", 1)).faults, disagree("tank"));
    EXPECT_THAT(doubts_of(fmt::format(tank, "lid", 1)).notes,
                Contains(HasSubstr("faces 'tank' and 'lid' run through a common edge in the same direction")));
    EXPECT_THAT(doubts_of(fmt::format(ball, 1, "high", "outward")).faults, IsEmpty());
    EXPECT_THAT(doubts_of(fmt::format(ball, -1, "low", "outward")).faults, IsEmpty());
    EXPECT_THAT(doubts_of(fmt::format(ball, 1, "high", "inward")).faults, disagree("ball"));
    EXPECT_THAT(doubts_of(fmt::format(ball, -1, "low", "inward")).faults, disagree("ball"));
}

struct Group {
    std::string name;
    std::vector<std::vector<Vector3d>> polygons;
};

/// An OBJ file of polygons that are turned and moved, with corners rounded to decimals.
std::string placed_obj(const std::vector<Group>& groups, const Eigen::Isometry3d& place, int decimals) {
    std::string vertices;
    std::string polygons;
    std::size_t corners = 0;
    for (const Group& group : groups) {
        polygons += fmt::format("g {}\n", group.name);
        for (const auto& polygon : group.polygons) {
            polygons += "f";
            for (const Vector3d& corner : polygon) {
                const Vector3d there = place * corner;
                vertices += fmt::format("v {:.{}f} {:.{}f} {:.{}f}\n", there.x(), decimals, there.y(), decimals,
                                        there.z(), decimals);
                polygons += fmt::format(" {}", ++corners);
            }
            polygons += "\n";
        }
    }
    return vertices + polygons;
}

std::vector<Vector3d> rectangle(double x0, double x1, double y0, double y1, bool turned = false) {
    std::vector<Vector3d> corners{{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}};
    if (turned) std::reverse(corners.begin(), corners.end());
    return corners;
}

// The floor's pieces face both ways: a repair has to give the whole factor, and otherwise there is a fault.
TEST(Winding, NeverHalvesAFactorInSilence) {
    const std::vector<std::vector<std::vector<Vector3d>>> floors{
        {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 0, 0}, {0, 1, 0}, {1, 1, 0}}},                 // halves
        {rectangle(0, 1, 0, 0.5), rectangle(0, 0.4, 0.5, 1, true), rectangle(0.4, 1, 0.5, 1)},  // a T-junction
        {rectangle(0, 0.3, 0, 1), rectangle(0.3, 1, 0, 0.6, true), rectangle(0.3, 1, 0.6, 1, true)},
    };
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int repetition = 0; repetition < 60; ++repetition) {
        const auto& floor = floors[static_cast<std::size_t>(repetition) % floors.size()];
        const int decimals = 3 + repetition % 7;
        Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
        place.rotate(Eigen::AngleAxisd(3 * uniform(random),
                                       Vector3d(uniform(random), uniform(random), uniform(random)).normalized()));
        place.pretranslate(Vector3d(10 * uniform(random), 10 * uniform(random), 10 * uniform(random)));
        std::vector<Vector3d> roof = rectangle(0, 1, 0, 1, true);
        for (Vector3d& corner : roof) corner.z() = 1;
        const std::string text = placed_obj({{"floor", floor}, {"roof", {roof}}}, place, decimals);
        const Scene scene = make_scene(source_of_file("a.obj", text));
        if (!examine_scene(scene).faults.empty()) continue;
        form_factors::Request request;
        request.tolerance = 1e-3;
        const auto matrix = form_factors::find_matrix(scene, request);
        EXPECT_NEAR(matrix.exchange(0, 1).value / matrix.areas[0], 0.1998, 3e-3) << text;
    }
}

/// Two storeys on either side of a wall, whose panels face opposite ways above and below the slab.
TEST(Winding, IsSoundWhereAThirdSurfaceMeetsTheEdge) {
    const std::string text =
        "v 0 0 0\nv 0 2 0\nv 0 2 1\nv 0 0 1\nv 0 0 2\nv 0 2 2\nv -1 0 1\nv -1 3 1\nv 0 3 1\nv 1 0 1\nv 1 3 1\n"
        "g wall\nf 1 2 3 4\nf 4 5 6 3\ng slab\nf 4 9 8 7\n";
    const Scene scene = make_scene(source_of_file("a.obj", text));
    EXPECT_THAT(scene.remarks, IsEmpty());
    EXPECT_THAT(examine_scene(scene).faults, IsEmpty());
    const auto without_slab = text.substr(0, text.find("g slab"));
    EXPECT_THAT(examine_scene(make_scene(source_of_file("a.obj", without_slab + "g other\nf 7 8 11\n"))).faults,
                ElementsAre(HasSubstr("surfaces of face 'wall' meet in an edge")));
}

/// The doubts about an OBJ file, and what reading it changed.
SceneDoubts doubts_about_obj(const std::string& text) {
    return examine_scene(make_scene(source_of_file("a.obj", text)));
}

TEST(Winding, IsSoundWhereABodyStandsAtTheEdgeOfASheet) {
    const std::string table =
        "v 0 0 0\nv 4 0 0\nv 4 3 0\nv 0 3 0\nv 0 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 1 1\nv 1 1 1\nv 1 2 1\nv 0 2 1\n"
        "g things\nf 1 2 3 4\nf 5 6 10 9\nf 6 7 11 10\nf 7 8 12 11\nf 8 5 9 12\nf 9 10 11 12\n";
    EXPECT_THAT(doubts_about_obj(table).faults, IsEmpty());
    EXPECT_THAT(doubts_about_obj(table).notes, ElementsAre(HasSubstr("5.88 % of face 'things' is covered")));
}

// A wall that is one piece beside walls and a roof of two is not turned round by these edges alone.
TEST(Winding, IsAFaultWhereEdgesOfOtherLengthsAtAnAngleDisagree) {
    const std::string room =
        "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\nv 1 0 0\nv 1 0 2\nv 1 2 0\nv 1 2 2\n"
        "g all of it\nf 1 9 11 4\nf 9 2 3 11\nf 5 8 12 10\nf 10 12 7 6\nf 2 6 7 3\nf 4 8 5 1\nf 3 7 12 11\nf 11 12 8 "
        "4\n";
    EXPECT_THAT(doubts_about_obj(room + "f 1 5 6 2\n").faults, IsEmpty());
    EXPECT_THAT(doubts_about_obj(room + "f 1 5 6 2\n").notes, testing::Each(HasSubstr("sees mostly itself")));
    EXPECT_THAT(doubts_about_obj(room + "v 0 0 1\nv 2 0 1\nf 2 14 13 1\nf 13 14 6 5\n").faults,
                Contains(HasSubstr("surfaces of face 'all of it' meet in an edge")));
}

/// The rim is as high as one step of the coordinates.
TEST(Winding, IsSoundWhereSurfacesAreNarrow) {
    const std::string rim =
        "v 0 0 0\nv 4.07 0 0\nv 4.07 3.11 0\nv 0 3.11 0\nv 0 0 0.01\nv 2.04 0 0.01\nv 2.04 0 0\nv 4.07 0 0.01\n"
        "g tray\nf 1 2 3 4\nf 5 6 7 1\nf 6 8 2 7\n";
    EXPECT_THAT(doubts_about_obj(rim).faults, IsEmpty());
    EXPECT_THAT(doubts_about_obj(rim).notes, IsEmpty());
}

/// A box with four of its six sides reversed has to face outwards in its room all the same.
TEST(Winding, IsAFaultWhereAMajorityWouldTurnABodyInsideOut) {
    const std::string room =
        "v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nv 0 0 9\nv 9 0 9\nv 9 9 9\nv 0 9 9\n"
        "g things\nf 1 2 3 4\nf 5 8 7 6\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n"
        "v 4 4 4\nv 5 4 4\nv 5 5 4\nv 4 5 4\nv 4 4 5\nv 5 4 5\nv 5 5 5\nv 4 5 5\n";
    const std::string outwards = "f 12 11 10 9\nf 14 15 16 13\n";
    EXPECT_THAT(doubts_about_obj(room + outwards + "f 9 13 14 10\nf 10 14 15 11\nf 11 15 16 12\nf 12 16 13 9\n").faults,
                Contains(HasSubstr("surfaces of face 'things' meet in an edge")));
    EXPECT_THAT(doubts_about_obj(room + outwards + "f 10 14 13 9\nf 11 15 14 10\nf 12 16 15 11\nf 12 16 13 9\n").faults,
                IsEmpty());
}

TEST(Winding, OfCirclesSaysNothingWhereAPlateMeetsThem) {
    const auto disc = [](int normal, double inner, double outer) {
        return fmt::format(
            "[[surface]]\nface = 'a'\nshape = 'disc'\ncentre = [0, 0, 1]\nnormal = [0, 0, {}]\ninner_radius = {}\n"
            "radius = {}\n",
            normal, inner, outer);
    };
    const auto pipe = [](int base, std::string_view facing) {
        return fmt::format(
            "[[surface]]\nface = 'a'\nshape = 'cylinder'\nbase = [0, 0, {}]\naxis = [0, 0, 1]\nradius = 1\n"
            "facing = '{}'\n",
            base, facing);
    };
    const auto faults_of = [](const std::string& text) {
        return examine_scene(make_scene(source_of_file("a.toml", text))).faults;
    };
    const auto disagree = ElementsAre(HasSubstr("surfaces of face 'a' meet in an edge and face opposite ways"));
    const std::string pipes = pipe(0, "outward") + pipe(1, "inward");
    EXPECT_THAT(faults_of(pipes), disagree);
    EXPECT_THAT(faults_of(pipes + disc(1, 0, 2) + disc(-1, 0, 2)), IsEmpty());
    EXPECT_THAT(faults_of(disc(1, 0, 1) + disc(1, 1, 2)), IsEmpty());
    EXPECT_THAT(faults_of(disc(1, 0, 1) + disc(-1, 1, 2)), disagree);
}

}  // namespace
}  // namespace ff::studies
