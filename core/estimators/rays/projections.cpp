#include "core/estimators/rays/projections.hpp"

#include "core/geometry/placement.hpp"
#include "core/visibility/mirrors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ff {
namespace {

/// [0, 1) in fixed point.
std::uint32_t fixed_point(double value) {
    constexpr double largest = 4294967295.0;
    return static_cast<std::uint32_t>(std::clamp(value * 0x1p32, 0.0, largest));
}

}  // namespace

void PixelDirections::add(const Eigen::Vector3d& direction, double factor) {
    const double turns = std::atan2(direction.y(), direction.x()) / (2 * std::numbers::pi);
    squared_sine_.push_back(fixed_point(direction.head<2>().squaredNorm() / direction.squaredNorm()));
    azimuth_.push_back(fixed_point(turns < 0 ? turns + 1 : turns));
    factor_.push_back(factor);
}

void PixelDirections::fill(std::size_t first, PointBlock& block) const {
    constexpr std::uint32_t middle = 1u << 31;
    std::fill_n(block.coordinate[0].begin(), block.size, middle);
    std::fill_n(block.coordinate[1].begin(), block.size, middle);
    std::copy_n(squared_sine_.begin() + static_cast<std::ptrdiff_t>(first), block.size, block.coordinate[2].begin());
    std::copy_n(azimuth_.begin() + static_cast<std::ptrdiff_t>(first), block.size, block.coordinate[3].begin());
}

PixelProjection::PixelProjection(const Scene& scene, TracerChoice tracer)
    : SceneEstimator(scene, tracer), placed_(placed(scene)), tracer_(make_tracer(scene, tracer)) {}

Eigen::MatrixXd PixelProjection::factors(Subdivision subdivision, const PixelDirections& pixels) const {
    const auto faces = static_cast<Eigen::Index>(scene().faces.size());
    Eigen::MatrixXd factors = Eigen::MatrixXd::Zero(faces, faces);
    const auto block = std::make_unique<PointBlock>();
    std::vector<Hit> hits;
    for (std::uint32_t s = 0; s < scene().surfaces.size(); ++s) {
        const Surface& surface = scene().surfaces[s];
        if (!is_of_face(surface)) continue;
        const Grid grid = subdivision.of(surface);
        const double share = area(surface.shape) / face_area(scene(), surface.face) / grid.parts();
        for (std::uint32_t patch = 0; patch < grid.parts(); ++patch) {
            for (std::size_t done = 0; done < pixels.size(); done += block->size) {
                block->size = std::min(block_capacity, pixels.size() - done);
                pixels.fill(done, *block);
                hits.resize(block->size);
                tracer_->find_ends(placed_.surfaces[s], s, grid, patch, *block, hits);
                for (std::size_t i = 0; i < hits.size(); ++i) {
                    if (hits[i].surface == no_surface || !hits[i].received) continue;
                    factors(surface.face, scene().surfaces[hits[i].surface].face) += share * pixels.factor(done + i);
                }
            }
        }
    }
    return factors;
}

std::string PixelProjection::no_such_size(std::string_view rule, std::uint64_t below, std::uint64_t above) {
    if (below == 0) return fmt::format("({}). Try {}.", rule, above);
    return fmt::format("({}). Try {} or {}.", rule, below, above);
}

std::uint64_t finest_resolution(std::uint64_t (*count)(std::uint64_t), std::uint64_t samples) {
    std::uint64_t finest = 0;
    for (std::uint64_t step = 1u << 29; step > 0; step /= 2) {
        if (count(finest + step) <= samples) finest += step;
    }
    return finest;
}

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
