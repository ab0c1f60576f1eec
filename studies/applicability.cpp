#include "studies/applicability.hpp"

#include "core/error.hpp"
#include "core/exact.hpp"
#include "core/facing.hpp"

#include <fmt/format.h>

namespace ff::studies {
namespace {

/// Single precision traces boxes in this range without loss.
constexpr double least_edge = 1e-9;
constexpr double largest_edge = 1e9;
constexpr double largest_edge_ratio = 1e4;

void expect_box(const Method& method, const Scene& scene) {
    if (scene.empty_box) return;
    throw UserError(
        fmt::format("method '{}' asks for the box tracer (scene '{}' is not an empty box). Use tracer = \"embree\".",
                    method.name, scene.name));
}

/// Rays have single precision.
void expect_traceable(const Scene& scene) {
    if (!scene.empty_box) return;
    const double least = scene.empty_box->minCoeff();
    const double largest = scene.empty_box->maxCoeff();
    if (least >= least_edge && largest <= largest_edge && largest <= least * largest_edge_ratio) return;
    throw UserError(
        fmt::format("scene '{}': cannot be traced (rays have single precision: edges from {:g} to {:g}, in a ratio of "
                    "at most {:g}). "
                    "Use another unit of length, or estimator = \"closed_form\".",
                    scene.name, least_edge, largest_edge, largest_edge_ratio));
}

/// Something may stand between two faces of a scene that is not convex, and only rays notice it.
void expect_unoccluded(const Method& method, const Scene& scene) {
    if (is_convex(scene)) return;
    throw UserError(fmt::format(
        "method '{}': {} cannot be used in scene '{}' (it is not convex, and the estimator does not see what stands "
        "between two faces). Use estimator = \"ray_shooting\".",
        method.name, name(method.estimator), scene.name));
}

void expect_parallelograms(const Method& method, const Scene& scene) {
    if (has_only_parallelograms(scene)) return;
    throw UserError(fmt::format(
        "method '{}': {} cannot be used in scene '{}' (it lays points on parallelograms only). Use estimator = "
        "\"ray_shooting\".",
        method.name, name(method.estimator), scene.name));
}

void expect_formulas(const Method& method, const Scene& scene) {
    if (exact_form_factors(scene)) return;
    throw UserError(
        fmt::format("method '{}': scene '{}' has no closed form. Use another estimator.", method.name, scene.name));
}

}  // namespace

void expect_applicable(const Method& method, const Scene& scene) {
    switch (method.estimator) {
        case Estimator::ray_shooting:
            if (method.tracer == TracerChoice::box) expect_box(method, scene);
            expect_traceable(scene);
            break;
        case Estimator::area_kernel:
        case Estimator::point_to_polygon:
            expect_unoccluded(method, scene);
            expect_parallelograms(method, scene);
            break;
        case Estimator::closed_form:
            expect_unoccluded(method, scene);
            expect_formulas(method, scene);
            break;
    }
}

}  // namespace ff::studies
