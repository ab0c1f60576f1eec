#include "core/estimators/rays/hemicube.hpp"

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

}  // namespace ff
