#include "studies/theory/applicability.hpp"

#include "core/exact/exact.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/support/error.hpp"
#include "core/visibility/mirrors.hpp"
#include "core/visibility/occlusion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ff::studies {
namespace {

/// Single precision traces boxes in this range without loss.
constexpr double least_edge = 1e-9;
constexpr double largest_edge = 1e9;
constexpr double largest_edge_ratio = 1e4;

/// Extents of scenes whose coordinates keep four digits of them in single precision.
constexpr double least_extent = 1e-3;

/// Coordinates far from the origin have few digits left for the scene.
void expect_near_origin(const Scene& scene) {
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
    if (size >= least_extent * farthest && size >= least_edge && size <= largest_edge) return;
    throw UserError(fmt::format(
        "scene '{}': cannot be traced (rays have single precision: it may be from {:g} to {:g} large, and at "
        "most {:g} times as far from the origin). Move it there, or use another unit of length.",
        scene.name, least_edge, largest_edge, 1 / least_extent));
}

void expect_box(const Method& method, const Scene& scene) {
    if (scene.empty_box) return;
    throw UserError(
        fmt::format("method '{}' asks for the box tracer (scene '{}' is not an empty box). Use tracer = \"embree\".",
                    method.name, scene.name));
}

/// Rays have single precision.
void expect_traceable(const Scene& scene) {
    if (!scene.empty_box) return expect_near_origin(scene);
    const double least = scene.empty_box->minCoeff();
    const double largest = scene.empty_box->maxCoeff();
    if (least >= least_edge && largest <= largest_edge && largest <= least * largest_edge_ratio) return;
    throw UserError(
        fmt::format("scene '{}': cannot be traced (rays have single precision: edges from {:g} to {:g}, in a ratio of "
                    "at most {:g}). "
                    "Use another unit of length, or estimator = \"closed_form\".",
                    scene.name, least_edge, largest_edge, largest_edge_ratio));
}

/// Only rays and the area kernel notice what stands between two faces.
void expect_unoccluded(const Method& method, const Scene& scene) {
    if (!may_be_occluded(scene)) return;
    throw UserError(
        fmt::format("method '{}': {} cannot be used in scene '{}' (something may stand between two of its faces, which "
                    "the estimator "
                    "does not see). Use estimator = \"ray_shooting\" or \"area_kernel\".",
                    method.name, name(method.estimator), scene.name));
}

void expect_parallelograms(const Method& method, const Scene& scene) {
    if (has_only_parallelograms(scene)) return;
    throw UserError(
        fmt::format("method '{}': {} cannot be used in scene '{}' (not all of its surfaces are parallelograms). "
                    "Use estimator = \"ray_shooting\" or \"area_kernel\".",
                    method.name, name(method.estimator), scene.name));
}

void expect_formula(const Method& method, const Scene& scene) {
    if (exact_form_factors(scene)) return;
    throw UserError(fmt::format(
        "method '{}': scene '{}' has no closed form (there is one for rectangles along the axes{}). "
        "Use another estimator.",
        method.name, scene.name, mirrors(scene).empty() ? "" : ", and in mirrors of boxes that are not opposite"));
}

/// Only rays go on from a mirror; closed forms know its images.
void expect_reflections(const Method& method, const Scene& scene) {
    if (method.estimator == Estimator::ray_shooting || method.estimator == Estimator::closed_form) return;
    throw UserError(
        fmt::format("method '{}': {} cannot be used in scene '{}' with mirrors (it sees nothing by way of them). Use "
                    "estimator = \"ray_shooting\", or leave 'mirrors' out.",
                    method.name, name(method.estimator), scene.name));
}

}  // namespace

void expect_applicable(const Method& method, const Scene& scene) {
    if (!mirrors(scene).empty()) expect_reflections(method, scene);
    switch (method.estimator) {
        case Estimator::ray_shooting:
            if (method.tracer == TracerChoice::box) expect_box(method, scene);
            expect_traceable(scene);
            break;
        case Estimator::area_kernel:
            break;
        case Estimator::point_to_polygon:
            expect_parallelograms(method, scene);
            expect_unoccluded(method, scene);
            break;
        case Estimator::closed_form:
            expect_unoccluded(method, scene);
            expect_formula(method, scene);
            break;
    }
}

}  // namespace ff::studies
