#include "core/estimators/hemicube.hpp"

#include <cmath>
#include <numbers>

namespace ff {
namespace {

/// The largest even r with at most `samples` pixels.
std::uint64_t resolution(std::uint64_t samples) {
    auto r = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(samples) / 3));
    while (3 * (r + 1) * (r + 1) <= samples) ++r;
    return r - r % 2;
}

}  // namespace

PixelDirections Hemicube::pixels(std::uint64_t samples) {
    const std::uint64_t r = resolution(samples);
    const double edge = 2.0 / static_cast<double>(r);
    PixelDirections pixels(samples);
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

std::string Hemicube::size_problem(std::uint64_t samples) {
    const std::uint64_t r = resolution(samples);
    if (r > 0 && 3 * r * r == samples) return {};
    return no_such_resolution("a hemicube has 3 r^2 pixels, r even", 3 * r * r, 3 * (r + 2) * (r + 2));
}

}  // namespace ff
