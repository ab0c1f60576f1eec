// Form factors do not depend on where a scene lies, how large it is and which way it is turned.

#include "core/geometry/box.hpp"
#include "core/geometry/placement.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "studies/scene_files/scene_file.hpp"
#include "tests/support/round_scenes.hpp"

#include <fmt/format.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace ff::studies::form_factors {
namespace {

using Eigen::Vector3d;

/// The level of each entry's interval: the probability that any of the few thousand intervals in this file excludes a
/// true value by chance is below 1e-4.
constexpr double place_level = 1 - 1e-8;
constexpr double place_tolerance = 0.004;

Scene turned(Scene scene, const Eigen::Matrix3d& turn) {
    for (Surface& surface : scene.surfaces) {
        surface.normal = turn * surface.normal;
        if (auto* p = std::get_if<Parallelogram>(&surface.shape))
            *p = {turn * p->corner, turn * p->edge_u, turn * p->edge_v};
        if (auto* p = std::get_if<Disc>(&surface.shape)) p->centre = turn * p->centre;
        if (auto* p = std::get_if<Frustum>(&surface.shape)) {
            p->base = turn * p->base;
            p->axis = turn * p->axis;
        }
    }
    scene.empty_box.reset();
    return scene;
}

/// A can of radius 1 and height 2: wall, base and top.
Scene can() {
    const Vector3d up(0, 0, 1);
    return test::faces_of({test::wall({0, 0, 0}, 2 * up, 1, 1, Facing::inward), test::disc({0, 0, 0}, up, 1),
                           test::disc({0, 0, 2}, -up, 1)},
                          true);
}

/// F(base -> top) = 3 - sqrt(8): X = 2 + 4, F = (X - sqrt(X^2 - 4)) / 2 [howell] C-41
const double base_to_top = 3 - std::sqrt(8);

/// A room with a block in it.
Scene furnished_room() {
    Scene scene = make_box(4, 3, 2.5);
    const Scene block = make_box(1, 1, 1);
    scene.faces.emplace_back("block");
    for (Surface surface : block.surfaces) {
        parallelogram(surface).corner += Vector3d(1.5, 1, 0.5);
        surface.normal = -surface.normal;
        surface.face = 6;
        scene.surfaces.push_back(surface);
    }
    scene.empty_box.reset();
    return scene;
}

Matrix matrix_with_seed(const Scene& scene, std::uint64_t seed) {
    Request request;
    request.tolerance = place_tolerance;
    request.level = place_level;
    request.seed = Seed{seed};
    return find_matrix(scene, request);
}

/// A random place up to 10^7 sizes away, a random size and a random direction.
struct Move {
    Eigen::Matrix3d turn;
    Vector3d by;  ///< displacement in sizes of the scene
    double scale;

    [[nodiscard]] Scene of(const Scene& scene) const { return placed(turned(scene, turn), {-by, 1 / scale}); }
};

class Moves {
  public:
    explicit Moves(std::uint64_t seed) : engine_(seed) {}

    Move next() {
        const Eigen::Quaterniond turn(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(0.1, 1));
        const double far = std::pow(10, uniform(0, 7));
        const Vector3d by(uniform(-1, 1) * far, uniform(-1, 1) * far, uniform(-1, 1) * far);
        return {turn.normalized().toRotationMatrix(), by, std::pow(10, uniform(-18, 18))};
    }

  private:
    std::mt19937_64 engine_;

    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }
};

constexpr std::uint64_t move_count = 8;

// An error of more than two tolerances is sure to be found: in single precision at the origin of coordinates there were
// such errors beyond 10^5 sizes, and at sizes of 10^19 all factors were 0.
TEST(FormFactorPlaces, DoNotMatterForACylinder) {
    Moves random(16);
    for (std::uint64_t seed = 1; seed <= move_count; ++seed) {
        const Scene scene = random.next().of(can());
        const Matrix matrix = matrix_with_seed(scene, seed);
        // Corners 10^7 sizes away are rounded by 10^-9 of a size.
        const double area = matrix.areas[1];
        const FaceExchange& pair = matrix.exchange(1, 2);
        EXPECT_LE(pair.low / area, base_to_top + 1e-7) << seed;
        EXPECT_GE(pair.high / area, base_to_top - 1e-7) << seed;
        EXPECT_LE(matrix.exchange(0, 1).low / area, 1 - base_to_top + 1e-7) << seed;
        EXPECT_GE(matrix.exchange(0, 1).high / area, 1 - base_to_top - 1e-7) << seed;
        EXPECT_EQ(matrix.missed(), 0u) << seed;
        EXPECT_TRUE(is_trusted(scene, matrix, place_tolerance)) << seed;
    }
}

TEST(FormFactorPlaces, DoNotMatterForAFurnishedRoom) {
    const Scene room = furnished_room();
    const Matrix here = matrix_with_seed(room, 1);
    Moves random(3);
    for (std::uint64_t seed = 1; seed <= move_count; ++seed) {
        const Scene scene = random.next().of(room);
        const Matrix there = matrix_with_seed(scene, seed);
        const double unit = there.areas[0] / here.areas[0];
        for (std::size_t from = 0; from < here.faces(); ++from) {
            for (std::size_t to = from; to < here.faces(); ++to) {
                const FaceExchange a = here.exchange(from, to);
                const FaceExchange b = there.exchange(from, to);
                const double room_for_rounding = 1e-7 * here.areas[from];
                EXPECT_LE(a.low, b.high / unit + room_for_rounding) << seed;
                EXPECT_GE(a.high, b.low / unit - room_for_rounding) << seed;
            }
        }
        EXPECT_EQ(there.missed(), 0u) << seed;
        EXPECT_TRUE(is_trusted(scene, there, place_tolerance)) << seed;
    }
}

/// The plan of a closed room with upright walls.
struct Plan {
    std::vector<std::pair<double, double>> outline;  ///< counterclockwise
    std::vector<std::vector<std::size_t>> floor;     ///< convex parts, corners from 0
};

const Plan box_plan{{{0, 0}, {5, 0}, {5, 7}, {0, 7}}, {{0, 1, 2, 3}}};
const Plan l_plan{{{0, 0}, {7, 0}, {7, 3}, {3, 3}, {3, 5}, {0, 5}}, {{0, 1, 2, 3}, {0, 3, 4, 5}}};

/// The room, 3 units high, with all its coordinates so far off; through an OBJ file with so many decimals.
Scene read_room(const Plan& plan, double unit, double far, int decimals) {
    const std::size_t n = plan.outline.size();
    std::string text = "# closed\n";
    for (const double height : {0.0, 3.0}) {
        for (const auto& [x, y] : plan.outline)
            text += fmt::format("v {1:.{0}f} {2:.{0}f} {3:.{0}f}\n", decimals, far + unit * x, far + unit * y,
                                far + unit * height);
    }
    for (std::size_t i = 0; i < n; ++i)
        text += fmt::format("g wall{}\nf {} {} {} {}\n", i + 1, i + 1, n + i + 1, n + (i + 1) % n + 1, (i + 1) % n + 1);
    for (const std::vector<std::size_t>& part : plan.floor) {
        std::string below;
        std::string above;
        for (const std::size_t corner : part) {
            below += fmt::format(" {}", corner + 1);
            above.insert(0, fmt::format(" {}", n + corner + 1));
        }
        text += "g floor\nf" + below + "\ng ceiling\nf" + above + "\n";
    }
    return make_scene(source_of_file("room.obj", text));
}

// Whole numbers, and decimals, keep their few digits however far off a room is. Where double precision rounds them, the
// intervals say so: without that, the exact ones would exclude each other from 10^3 on.
TEST(FormFactorPlaces, DoNotMatterForRoomsOfFewDigits) {
    for (const Plan& plan : {box_plan, l_plan}) {
        for (const auto& [unit, decimals] : {std::pair(1.0, 0), {0.25, 2}, {0.1, 1}, {0.013, 3}}) {
            const Matrix here = matrix_with_seed(read_room(plan, unit, 0, decimals), 1);
            for (const double far : {1e3, 1e5, 1e7, 1e9}) {
                SCOPED_TRACE(fmt::format("{} corners, unit {}, at {}", plan.outline.size(), unit, far));
                const Scene scene = read_room(plan, unit, far, decimals);
                const bool is_rounded = unit != 1.0 && unit != 0.25;
                const SceneDoubts doubts = examine_scene(scene);
                EXPECT_THAT(doubts.faults, testing::IsEmpty());
                EXPECT_TRUE(is_rounded || doubts.notes.empty());
                EXPECT_TRUE(!is_rounded || far < 1e7 || !doubts.notes.empty());
                const Matrix there = matrix_with_seed(scene, 1);
                EXPECT_EQ(there.missed(), 0u);
                EXPECT_TRUE(is_trusted(scene, there, place_tolerance));
                for (std::size_t from = 0; from < here.faces(); ++from) {
                    for (std::size_t to = from; to < here.faces(); ++to) {
                        const FaceExchange a = here.exchange(from, to);
                        const FaceExchange b = there.exchange(from, to);
                        EXPECT_LE(a.low, b.high);
                        EXPECT_GE(a.high, b.low);
                        EXPECT_TRUE(is_rounded || a.is_sampled() || half_width(b) <= half_width(a) + 1e-12 * a.value);
                    }
                }
            }
        }
    }
}

// Checks the check: a slightly longer can has another factor.
TEST(FormFactorPlaces, CheckNoticesASlightlyLongerCan) {
    Scene longer = can();
    std::get<Frustum>(longer.surfaces[0].shape).axis *= 1.1;
    std::get<Disc>(longer.surfaces[2].shape).centre *= 1.1;
    const FaceExchange pair = matrix_with_seed(longer, 1).exchange(1, 2);
    EXPECT_LT(pair.high / std::acos(-1.0), base_to_top);
}

/// Squares of 1e-5 with a plate of 1e8 in between.
TEST(FormFactors, NoticeAnOccluderHoweverMuchLargerThanThePair) {
    const auto plate = [](double from, double edge, double height, double up, int face) {
        return Surface{Parallelogram{{from, from, height}, {edge, 0, 0}, {0, edge, 0}}, {0, 0, up}, face};
    };
    for (const double half : {1.0, 1e2, 1e4, 1e8}) {
        Scene scene;
        scene.faces = {"a", "b"};
        scene.surfaces = {plate(0, 1e-5, 0, 1, 0), plate(0, 1e-5, 1e-5, -1, 1),
                          plate(-half, 2 * half, 5e-6, 1, no_face)};
        const Matrix matrix = find_matrix(scene, {});
        const FaceExchange pair = matrix.exchange(0, 1);
        EXPECT_EQ(pair.low, 0) << half;
        EXPECT_LT(pair.value / matrix.areas[0], 0.01) << half;
        EXPECT_TRUE(matrix.missed() == 1 || pair.high / matrix.areas[0] <= 1e-5);
    }
}

}  // namespace
}  // namespace ff::studies::form_factors
