#include "core/estimators/rays/projections.hpp"

#include <cmath>
#include <numbers>

namespace ff {

PixelDirections Hemicube::lay(std::uint64_t half_r) {
    const std::uint64_t r = 2 * half_r;
    const double edge = 2.0 / static_cast<double>(r);
    PixelDirections pixels(count(half_r));
    // The top is at z = 1, the sides stand at distance 1.
    const auto add = [&](const Eigen::Vector3d& direction) {
        const double squared = direction.squaredNorm();
        pixels.add(direction, direction.z() * edge * edge / (std::numbers::pi * squared * squared));
    };
    const auto centre = [&](std::uint64_t i) { return -1 + (static_cast<double>(i) + 0.5) * edge; };
    for (std::uint64_t j = 0; j < r; ++j) {
        for (std::uint64_t i = 0; i < r; ++i) add({centre(i), centre(j), 1});
    }
    for (std::uint64_t j = r / 2; j < r; ++j) {
        for (std::uint64_t i = 0; i < r; ++i) {
            add({1, centre(i), centre(j)});
            add({-centre(i), 1, centre(j)});
            add({-1, -centre(i), centre(j)});
            add({centre(i), -1, centre(j)});
        }
    }
    return pixels;
}

PixelDirections CubicTetrahedron::lay(std::uint64_t r_less_1) {
    const std::uint64_t r = r_less_1 + 1;
    const double edge = 3.0 / static_cast<double>(r);
    const auto centre = [&](std::uint64_t i) { return -2 + (static_cast<double>(i) + 0.5) * edge; };
    // The cube's axes in those of the patch: its diagonal is the normal.
    const double a = 1 / std::sqrt(2.0);
    const double b = 1 / std::sqrt(6.0);
    const double c = 1 / std::sqrt(3.0);
    const Eigen::Matrix3d turn{{a, -a, 0}, {b, b, -2 * b}, {c, c, c}};
    PixelDirections pixels(count(r_less_1));
    for (int axis = 0; axis < 3; ++axis) {
        for (std::uint64_t j = 0; j < r; ++j) {
            for (std::uint64_t i = r - j; i < r; ++i) {
                Eigen::Vector3d direction;
                direction[axis] = 1;
                direction[(axis + 1) % 3] = centre(i);
                direction[(axis + 2) % 3] = centre(j);
                const double squared = direction.squaredNorm();
                pixels.add(turn * direction,
                           direction.sum() * c * edge * edge / (std::numbers::pi * squared * squared));
            }
        }
    }
    return pixels;
}

PixelDirections SinglePlane::lay(std::uint64_t half_r) {
    const std::uint64_t r = 2 * half_r;
    const double edge = 2 * reach / static_cast<double>(r);
    const auto centre = [&](std::uint64_t i) { return -reach + (static_cast<double>(i) + 0.5) * edge; };
    PixelDirections pixels(count(half_r));
    for (std::uint64_t j = 0; j < r; ++j) {
        for (std::uint64_t i = 0; i < r; ++i) {
            const Eigen::Vector3d direction{centre(i), centre(j), 1};
            const double squared = direction.squaredNorm();
            pixels.add(direction, edge * edge / (std::numbers::pi * squared * squared));
        }
    }
    return pixels;
}

}  // namespace ff
