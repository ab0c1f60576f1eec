#include "core/scene.hpp"

#include "core/contract.hpp"

#include <Eigen/Geometry>

#include <cstddef>

namespace ff {

double area(const Parallelogram& shape) {
    return shape.edge_u.cross(shape.edge_v).norm();
}

Parallelogram patch(const Parallelogram& shape, Subdivision subdivision, std::uint32_t index) {
    FF_EXPECT(subdivision.m >= 1);
    FF_EXPECT(index < subdivision.per_surface());
    const double m = subdivision.m;
    const double column = index % subdivision.m;
    const double row = index / subdivision.m;
    return {shape.corner + shape.edge_u * column / m + shape.edge_v * row / m, shape.edge_u / m, shape.edge_v / m};
}

double face_area(const Scene& scene, int face) {
    FF_EXPECT(face >= 0 && static_cast<std::size_t>(face) < scene.faces.size());
    double sum = 0;
    for (const Surface& surface : scene.surfaces) {
        if (surface.face == face) sum += area(surface.shape);
    }
    return sum;
}

}  // namespace ff
