#include "core/configurations/formulas/polygons.hpp"

#include "core/configurations/formulas/parameters.hpp"
#include "core/formulas/polygon_exchange.hpp"
#include "core/geometry/convex_polygon.hpp"

#include <cmath>
#include <numbers>

namespace ff {
namespace {

using Real = long double;

Real factor(const Corners<Real>& from, const Corners<Real>& to) {
    return polygon_exchange_area<Real>(from, to).value / polygon_area(from);
}

}  // namespace

long double rectangles_at_angle_factor(long double edge, long double from, long double to, long double angle) {
    expect_positive("rectangles at an angle", {{"edge", edge}, {"from", from}, {"to", to}, {"angle", angle}});
    expect_valid(angle < std::numbers::pi_v<Real>, "rectangles at an angle", "the angle is not below pi radians.");
    const Real y = to * std::cos(angle);
    const Real z = to * std::sin(angle);
    return factor({{0, 0, 0}, {edge, 0, 0}, {edge, from, 0}, {0, from, 0}},
                  {{0, 0, 0}, {0, y, z}, {edge, y, z}, {edge, 0, 0}});
}

long double parallel_right_triangles_factor() {
    return factor({{0, 1, 1}, {1, 1, 1}, {1, 0, 1}}, {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
}

long double tetrahedron_factor() {
    return factor({{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}}, {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}});
}

}  // namespace ff
