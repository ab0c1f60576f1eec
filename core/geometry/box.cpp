#include "core/geometry/box.hpp"

#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

namespace ff {
namespace {

using Eigen::Vector3d;

/// Beyond these, areas squared would leave the range of a double.
constexpr double shortest_edge = 1e-70;
constexpr double longest_edge = 1e70;

void require_edge(std::string_view edge, double length) {
    if (!std::isfinite(length) || length <= 0) {
        throw UserError("box edge {} = {} (an edge needs a finite, positive length). Try {} = 1.", edge, length, edge);
    }
    if (length < shortest_edge || length > longest_edge) {
        throw UserError(
            "box edge {} = {} (only {} to {} can be computed with). Choose another unit of "
            "length: form factors do not depend on it.",
            edge, length, shortest_edge, longest_edge);
    }
}

Surface wall(int face, const Vector3d& corner, const Vector3d& edge_u, const Vector3d& edge_v, const Vector3d& normal) {
    return {Parallelogram{corner, edge_u, edge_v}, normal, face};
}

}  // namespace

Scene make_box(double a, double b, double c) {
    require_edge("a", a);
    require_edge("b", b);
    require_edge("c", c);
    const Vector3d origin = Vector3d::Zero();
    const Vector3d x = Vector3d::UnitX();
    const Vector3d y = Vector3d::UnitY();
    const Vector3d z = Vector3d::UnitZ();

    Scene scene;
    scene.name = fmt::format("box:{}x{}x{}", a, b, c);
    scene.canonical = fmt::format("box a={} b={} c={}", a, b, c);
    scene.faces = {"1", "2", "3", "4", "5", "6"};
    scene.surfaces = {
        wall(0, origin, a * x, b * y, z),  //
        wall(1, b * y, a * x, c * z, -y),  //
        wall(2, origin, a * x, c * z, y),  //
        wall(3, origin, b * y, c * z, x),  //
        wall(4, a * x, b * y, c * z, -x),  //
        wall(5, c * z, a * x, b * y, -z),
    };
    scene.closed = true;
    scene.empty_box = Vector3d(a, b, c);
    return scene;
}

}  // namespace ff
