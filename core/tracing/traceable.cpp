#include "core/tracing/traceable.hpp"

#include "core/geometry/surface_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ff {
namespace {

/// Single precision traces boxes in this range without loss.
constexpr double least_edge = 1e-9;
constexpr double largest_edge = 1e9;
constexpr double largest_edge_ratio = 1e4;

/// Extents of scenes whose coordinates keep four digits of them in single precision.
constexpr double least_extent = 1e-3;

/// Coordinates far from the origin have few digits left for the scene.
bool is_near_origin(const Scene& scene) {
    double farthest = 0;
    double size = 0;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        for (const Surface& surface : scene.surfaces) {
            const Extent along = extent(surface, Eigen::Vector3d::Unit(axis));
            low = std::min(low, along.low);
            high = std::max(high, along.high);
        }
        farthest = std::max({farthest, std::abs(low), std::abs(high)});
        size = std::max(size, high - low);
    }
    return size >= least_extent * farthest && size >= least_edge && size <= largest_edge;
}

}  // namespace

std::string why_not_traceable(const Scene& scene) {
    if (!scene.empty_box) {
        if (is_near_origin(scene)) return {};
        return fmt::format(
            "scene '{}' cannot be traced (rays have single precision: it may be from {:g} to {:g} large, and at most "
            "{:g} times as far from the origin). Move it there, or use another unit of length.",
            scene.name, least_edge, largest_edge, 1 / least_extent);
    }
    const double least = scene.empty_box->minCoeff();
    const double largest = scene.empty_box->maxCoeff();
    if (least >= least_edge && largest <= largest_edge && largest <= least * largest_edge_ratio) return {};
    return fmt::format(
        "scene '{}' cannot be traced (rays have single precision: edges from {:g} to {:g}, in a ratio of at most "
        "{:g}). Use another unit of length, or estimator = \"closed_form\".",
        scene.name, least_edge, largest_edge, largest_edge_ratio);
}

}  // namespace ff
