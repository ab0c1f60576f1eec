#include "core/geometry/shaft.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <random>

namespace ff {
namespace {

using Eigen::Vector3d;
using Crossing = Shaft::Crossing;

ConvexPolygon rectangle(const Vector3d& corner, const Vector3d& u, const Vector3d& v) {
    return {corner, corner + u, corner + u + v, corner + v};
}

/// The result that both tests prove.
Crossing crossing(Shaft shaft, const ConvexPolygon& polygon) {
    const Plate plate(polygon);
    const Crossing crossing = shaft.crossed_by(plate);
    return crossing == Crossing::some && shaft.is_beside(plate) ? Crossing::none : crossing;
}

const ConvexPolygon floor_square = rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
const ConvexPolygon ceiling_square = rectangle({0, 0, 1}, {1, 0, 0}, {0, 1, 0});

TEST(Shaft, ExcludesPolygonsBesideIt) {
    Shaft shaft(floor_square, ceiling_square);
    EXPECT_EQ(crossing(shaft, rectangle({1.1, 0, 0.5}, {1, 0, 0}, {0, 1, 0})), Crossing::none);
    EXPECT_EQ(crossing(shaft, rectangle({1, 0, 0.2}, {1, 0, 0}, {0, 1, 0})), Crossing::none) << "it touches";
    EXPECT_EQ(crossing(shaft, rectangle({0, 0, 1.01}, {1, 0, 0}, {0, 1, 0})), Crossing::none) << "above";
    EXPECT_EQ(crossing(shaft, rectangle({0.99, 0.99, 0.5}, {1, 0, 0}, {0, 1, 0})), Crossing::some);
    // From a small place to the ceiling the shaft is narrow below: no plane across an axis would show it.
    const ConvexPolygon place = rectangle({0.5, 0.5, 0}, {1e-3, 0, 0}, {0, 1e-3, 0});
    EXPECT_EQ(crossing(Shaft(place, ceiling_square), rectangle({0.51, 0.5, 1e-3}, {1e-3, 0, 0}, {0, 1e-3, 0})),
              Crossing::none);
    EXPECT_EQ(crossing(Shaft(place, ceiling_square), rectangle({0.501, 0.5, 1e-3}, {1e-3, 0, 0}, {0, 1e-3, 0})),
              Crossing::some);
}

TEST(Shaft, IsClosedByASurfaceThatAllItsLinesCross) {
    Shaft shaft(floor_square, ceiling_square);
    EXPECT_EQ(crossing(shaft, rectangle({-0.1, -0.1, 0.5}, {1.2, 0, 0}, {0, 1.2, 0})), Crossing::all);
    EXPECT_EQ(crossing(shaft, rectangle({0.1, -0.1, 0.5}, {1.2, 0, 0}, {0, 1.2, 0})), Crossing::some);
    EXPECT_EQ(crossing(shaft, rectangle({-9, -9, 1.5}, {20, 0, 0}, {0, 20, 0})), Crossing::none) << "beyond it";
}

// Random lines through random polygons: a proof is never contradicted, and proofs of both kinds occur.
TEST(Shaft, ProvesOnlyWhatHoldsForEveryLine) {
    std::mt19937_64 engine(1);
    const auto draw = [&](double low, double high) { return std::uniform_real_distribution(low, high)(engine); };
    const auto direction = [&] { return Vector3d(draw(-1, 1), draw(-1, 1), draw(-1, 1)); };
    int clear = 0;
    int closed = 0;
    for (int scene = 0; scene < 4000; ++scene) {
        const auto any = [&](const Vector3d& at, double size) {
            return rectangle(at + 0.3 * direction(), size * direction(), size * direction());
        };
        const ConvexPolygon from = any({0, 0, 0}, 0.2);
        const ConvexPolygon to = any({0, 0, 2}, 0.5);
        const ConvexPolygon polygon = any({0, 0, draw(0.3, 1.7)}, std::exp(draw(-3, 1)));
        Shaft shaft(from, to);
        const bool is_clear = crossing(shaft, polygon) == Crossing::none;
        const bool is_closed = crossing(shaft, polygon) == Crossing::all;
        clear += is_clear;
        closed += is_closed;
        const auto place_on = [&](const ConvexPolygon& p) -> Vector3d {
            return p[0] + draw(0, 1) * (p[1] - p[0]) + draw(0, 1) * (p[3] - p[0]);
        };
        const Vector3d u = polygon[1] - polygon[0];
        const Vector3d v = polygon[3] - polygon[0];
        for (int line = 0; line < 50; ++line) {
            const Vector3d begin = place_on(from);
            const Vector3d along = place_on(to) - begin;
            Eigen::Matrix3d system;
            system << u, v, -along;
            const Vector3d at = system.partialPivLu().solve(begin - polygon[0]);
            const bool meets = at.minCoeff() > 1e-9 && at.maxCoeff() < 1 - 1e-9;
            const bool misses = at.minCoeff() < -1e-9 || at.maxCoeff() > 1 + 1e-9;
            EXPECT_FALSE(is_clear && meets);
            EXPECT_FALSE(is_closed && misses);
        }
    }
    EXPECT_GT(clear, 400);
    EXPECT_GT(closed, 20);
}

}  // namespace
}  // namespace ff
