#include "tests/unit/core/geometry/random_rectangles.hpp"

#include "core/geometry/box.hpp"
#include "core/geometry/scene.hpp"

#include <Eigen/Core>

#include <cstdlib>

namespace ff::test {
namespace {

using Eigen::Vector3d;

/// Every run checks the same cases. RC_PARAMS of the caller, e.g. to try other seeds, goes before.
// NOLINTNEXTLINE(concurrency-mt-unsafe): before there are threads
const int fixed_seed = setenv("RC_PARAMS", "seed=20261120 max_success=300", 0);

/// Multiples of 1/16 from low/16 to high/16, whatever size rapidcheck asks for.
rc::Gen<double> sixteenths(int low, int high) {
    return rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high + 1)),
                        [](int n) { return n / 16.0; });
}

Surface make_rectangle(const Vector3d& corner, double length_u, double length_v, int orientation) {
    const int axis = orientation % 3;
    const double side = orientation < 3 ? 1 : -1;
    return {Parallelogram{corner, length_u * Vector3d::Unit((axis + 1) % 3), length_v * Vector3d::Unit((axis + 2) % 3)},
            side * Vector3d::Unit(axis), 0};
}

/// Lower corner within `room` (in sixteenths) of `middle` along every axis.
rc::Gen<Surface> any_rectangle_near(const Vector3d& middle, int room, int longest) {
    return rc::gen::apply(
        [middle](double x, double y, double z, double u, double v, int orientation) {
            return make_rectangle(middle + Vector3d(x, y, z), u, v, orientation);
        },
        sixteenths(-room, room), sixteenths(-room, room), sixteenths(-room, room), sixteenths(1, longest),
        sixteenths(1, longest), rc::gen::inRange(0, 6));
}

}  // namespace

rc::Gen<Surface> any_rectangle() {
    return any_rectangle_near(Vector3d::Zero(), 24, 48);
}

rc::Gen<std::pair<Surface, Surface>> any_distant_pair() {
    // Corners within 1/2 of the origin and of a point 3 away along some axis; edges of up to 1 leave a distance of 1.
    return rc::gen::mapcat(rc::gen::inRange(0, 3), [](int axis) {
        return rc::gen::pair(any_rectangle_near(Vector3d::Zero(), 8, 16),
                             any_rectangle_near(3 * Vector3d::Unit(axis), 8, 16));
    });
}

rc::Gen<Scene> any_box() {
    const auto edge =
        rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::inRange(1, 4097)), [](int n) { return n / 64.0; });
    return rc::gen::apply(make_box, edge, edge, edge);
}

}  // namespace ff::test
