#include "core/estimators/rays/single_plane.hpp"

#include <cmath>
#include <numbers>

namespace ff {

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
