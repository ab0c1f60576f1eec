#include "core/geometry/aligned_rectangle.hpp"

#include <algorithm>

namespace ff {
namespace {

/// The only axis along which `vector` is not 0.
std::optional<std::size_t> axis_of(const Eigen::Vector3d& vector) {
    std::optional<std::size_t> axis;
    for (std::size_t k = 0; k < 3; ++k) {
        if (vector[static_cast<Eigen::Index>(k)] == 0) continue;
        if (axis) return std::nullopt;
        axis = k;
    }
    return axis;
}

}  // namespace

std::optional<AlignedRectangle> aligned_rectangle(const Surface& surface) {
    const auto* shape = std::get_if<Parallelogram>(&surface.shape);
    if (shape == nullptr) return std::nullopt;
    const auto& [corner, edge_u, edge_v] = *shape;
    const auto axis_u = axis_of(edge_u);
    const auto axis_v = axis_of(edge_v);
    const auto axis = axis_of(surface.normal);
    if (!axis_u || !axis_v || !axis || *axis_u == *axis_v || *axis_u == *axis || *axis_v == *axis) return std::nullopt;

    AlignedRectangle rectangle;
    rectangle.axis = *axis;
    rectangle.side = surface.normal[static_cast<Eigen::Index>(*axis)] > 0 ? 1 : -1;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto component = static_cast<Eigen::Index>(k);
        const long double begin = corner[component];
        // One of the two edges is 0 along this axis, or both are.
        const long double end = begin + static_cast<long double>(edge_u[component] + edge_v[component]);
        rectangle.extent[k] = {std::min(begin, end), std::max(begin, end)};
    }
    return rectangle;
}

}  // namespace ff
