#include "core/tracing/traceable.hpp"

#include <fmt/format.h>

namespace ff {
namespace {

/// Single precision traces boxes in this range without loss.
constexpr double least_edge = 1e-9;
constexpr double largest_edge = 1e9;
constexpr double largest_edge_ratio = 1e4;

}  // namespace

std::string why_not_traceable(const Scene& scene) {
    if (!scene.empty_box) return {};  // tracers move and scale it
    const double least = scene.empty_box->minCoeff();
    const double largest = scene.empty_box->maxCoeff();
    if (least >= least_edge && largest <= largest_edge && largest <= least * largest_edge_ratio) return {};
    return fmt::format(
        "scene '{}' cannot be traced (rays have single precision: edges from {:g} to {:g}, in a ratio of at most "
        "{:g}). Use another unit of length, or estimator = \"closed_form\".",
        scene.name, least_edge, largest_edge, largest_edge_ratio);
}

}  // namespace ff
