#include "core/estimators/cubic_tetrahedron.hpp"

#include <cmath>
#include <numbers>

namespace ff {
namespace {

std::uint64_t pixels_of(std::uint64_t r) {
    return 3 * r * (r - 1) / 2;
}

/// The largest r with at most `samples` pixels, at least 1 (which has none).
std::uint64_t resolution(std::uint64_t samples) {
    auto r = 1 + static_cast<std::uint64_t>(std::sqrt(2 * static_cast<double>(samples) / 3));
    while (r > 1 && pixels_of(r) > samples) --r;
    while (pixels_of(r + 1) <= samples) ++r;
    return r;
}

}  // namespace

PixelDirections CubicTetrahedron::pixels(std::uint64_t samples) {
    const std::uint64_t r = resolution(samples);
    const double edge = 3.0 / static_cast<double>(r);
    const auto centre = [&](std::uint64_t i) { return -2 + (static_cast<double>(i) + 0.5) * edge; };
    // The cube's axes in those of the patch: its diagonal is the normal.
    const double a = 1 / std::sqrt(2.0);
    const double b = 1 / std::sqrt(6.0);
    const double c = 1 / std::sqrt(3.0);
    const Eigen::Matrix3d turn{{a, -a, 0}, {b, b, -2 * b}, {c, c, c}};
    PixelDirections pixels(samples);
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

std::string CubicTetrahedron::size_problem(std::uint64_t samples) {
    const std::uint64_t r = resolution(samples);
    if (r > 1 && pixels_of(r) == samples) return {};
    return no_such_resolution("a cubic tetrahedron has 3 r (r - 1) / 2 pixels", pixels_of(r), pixels_of(r + 1));
}

}  // namespace ff
