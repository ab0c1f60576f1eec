#include "tests/unit/core/geometry/rectangles.hpp"

#include "core/geometry/scene.hpp"

#include <cmath>
#include <cstddef>
#include <sstream>
#include <utility>

namespace ff::test {
namespace {

using Eigen::Vector3d;

Vector3d lowest(const Parallelogram& shape) {
    return shape.corner.cwiseMin(shape.corner + shape.edge_u + shape.edge_v);
}

Vector3d highest(const Parallelogram& shape) {
    return shape.corner.cwiseMax(shape.corner + shape.edge_u + shape.edge_v);
}

}  // namespace

Surface rectangle(const std::string& text) {
    std::istringstream in(text);
    Vector3d low;
    Vector3d high;
    for (int axis = 0; axis < 3; ++axis) {
        char colon = 0;
        in >> low[axis] >> colon >> high[axis];
    }
    char side = 0;
    char letter = 0;
    in >> side >> letter;
    EXPECT_TRUE(in && side != 0 && letter >= 'x' && letter <= 'z') << text;

    const int axis = letter - 'x';
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    return {Parallelogram{low, (high[u] - low[u]) * Vector3d::Unit(u), (high[v] - low[v]) * Vector3d::Unit(v)},
            (side == '+' ? 1.0 : -1.0) * Vector3d::Unit(axis), 0};
}

Scene scene_of(std::vector<Surface> surfaces) {
    Scene scene;
    scene.surfaces = std::move(surfaces);
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
        scene.surfaces[i].face = static_cast<int>(i);
        scene.faces.push_back(std::to_string(i + 1));
    }
    return scene;
}

double squared_extent(const Surface& a, const Surface& b) {
    const Vector3d low = lowest(parallelogram(a)).cwiseMin(lowest(parallelogram(b)));
    const Vector3d high = highest(parallelogram(a)).cwiseMax(highest(parallelogram(b)));
    return (high - low).squaredNorm();
}

testing::AssertionResult same_exchange_area(double a, double b, double squared_extent, int parts) {
    const double allowed = 1e-15 * (parts + 1) * squared_extent;
    if (std::abs(a - b) <= allowed) return testing::AssertionSuccess();
    return testing::AssertionFailure() << a << " and " << b << " differ by " << a - b << ", allowed " << allowed;
}

Surface translated(Surface surface, const Vector3d& offset) {
    parallelogram(surface).corner += offset;
    return surface;
}

Surface scaled(Surface surface, double factor) {
    parallelogram(surface).corner *= factor;
    parallelogram(surface).edge_u *= factor;
    parallelogram(surface).edge_v *= factor;
    return surface;
}

Surface axes_rotated(const Surface& surface) {
    const auto rotate = [](const Vector3d& v) { return Vector3d(v[2], v[0], v[1]); };
    return {Parallelogram{rotate(parallelogram(surface).corner), rotate(parallelogram(surface).edge_u),
                          rotate(parallelogram(surface).edge_v)},
            rotate(surface.normal), surface.face};
}

Surface mirrored(Surface surface, int axis) {
    for (Vector3d* vector : {&parallelogram(surface).corner, &parallelogram(surface).edge_u,
                             &parallelogram(surface).edge_v, &surface.normal}) {
        (*vector)[axis] *= -1;
    }
    return surface;
}

}  // namespace ff::test
