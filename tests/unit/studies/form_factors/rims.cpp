#include "studies/form_factors/cells/part_bounds.hpp"

#include "core/visibility/visible_polygon.hpp"
#include "studies/form_factors/cells/cell_factors.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

namespace ff::studies::form_factors {
namespace {

using Eigen::Vector3d;

/// The largest change of what is seen, per length, over the bound, in scenes of a square below a target and plates.
/// @param with_plates  whether edges of the plates count in the bound
double largest_share_of_bound(bool with_plates) {
    std::mt19937 engine(7);
    std::uniform_real_distribution<double> uniform(0, 1);
    double largest = 0;
    for (int scene = 0; scene < 300; ++scene) {
        const auto plate = [&](double height, double size) {
            const Vector3d corner(uniform(engine), uniform(engine), height * (0.3 + uniform(engine)));
            const Vector3d u = size * Vector3d(uniform(engine), uniform(engine) - 0.5, uniform(engine) - 0.5);
            const Vector3d v = size * Vector3d(uniform(engine) - 0.5, uniform(engine), uniform(engine) - 0.5);
            return Surface{Parallelogram{corner, u, v}, -u.cross(v).normalized(), no_face};
        };
        const Surface source{Parallelogram{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 0, 1}, no_face};
        const Surface target = plate(3, 0.5);
        std::vector<Surface> plates;
        for (int k = 0; k < 3; ++k) plates.push_back(plate(1, uniform(engine) < 0.5 ? 0.2 : 4));
        std::vector<Blocker> blockers;
        for (const Surface& surface : plates) blockers.emplace_back(&surface);
        const auto above_source = [](const Surface& surface) {
            return clipped(corners(surface.shape), Vector3d::UnitZ(), 0);
        };
        if (above_source(target).empty()) continue;
        Rims rims(source, above_source(target));
        for (const Surface& surface : plates) rims.add_blocker(edges_of(above_source(surface)));
        std::vector<std::uint32_t> counted(with_plates ? plates.size() : 0);
        std::iota(counted.begin(), counted.end(), 0U);

        const VisiblePolygon visible(target, blockers);
        for (int k = 0; k < 30; ++k) {
            Quadrilateral part{{Vector3d(0, 0, 0), {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
            for (int halving = 0; halving < 8; ++halving) part = part.halves()[uniform(engine) < 0.5];
            const double slope = rims.slope(part.extent(), counted);
            if (!(slope > 0 && slope < 1e6)) continue;
            const auto place = [&] { return part.at({uniform(engine), uniform(engine)}); };
            const Vector3d a = place();
            const Vector3d b = place();
            const double change =
                std::abs(visible.from(a, source.normal).visible - visible.from(b, source.normal).visible);
            largest = std::max(largest, change / slope / (a - b).norm());
        }
    }
    return largest;
}

TEST(Rims, BoundHowFastFactorsChange) {
    const double share = largest_share_of_bound(true);
    EXPECT_LT(share, 1);
    EXPECT_GT(share, 0.2) << "the bound is of some use";
}

TEST(Rims, BoundFailsWithoutEdgesOfObstacles) {
    EXPECT_GT(largest_share_of_bound(false), 1);
}

}  // namespace
}  // namespace ff::studies::form_factors
