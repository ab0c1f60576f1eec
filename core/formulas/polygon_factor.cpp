#include "core/formulas/polygon_factor.hpp"

#include "core/geometry/convex_polygon.hpp"
#include "core/support/contract.hpp"

#include <algorithm>
#include <numbers>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/formulas/polygon_factor.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h comes first
#include "core/formulas/arc_angle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ff {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The contribution of the edge from `begin` to `end` at the points (x, y, 0), times 2 pi: the angle under which it is
/// seen times the cosine of edge x begin to the normal.
HWY_INLINE Doubles edge_term(Doubles x, Doubles y, const Eigen::Vector3d& begin, const Eigen::Vector3d& end) {
    const Eigen::Vector3d edge = end - begin;
    const auto ax = hn::Sub(constant(begin.x()), x);
    const auto ay = hn::Sub(constant(begin.y()), y);
    const auto bx = hn::Sub(constant(end.x()), x);
    const auto by = hn::Sub(constant(end.y()), y);
    const auto nx = hn::Sub(constant(edge.y() * begin.z()), hn::Mul(constant(edge.z()), ay));
    const auto ny = hn::Sub(hn::Mul(constant(edge.z()), ax), constant(edge.x() * begin.z()));
    const auto nz = hn::Sub(hn::Mul(constant(edge.x()), ay), hn::Mul(constant(edge.y()), ax));
    const auto sine = hn::Sqrt(hn::Add(hn::Add(hn::Mul(nx, nx), hn::Mul(ny, ny)), hn::Mul(nz, nz)));
    const auto cosine = hn::Add(hn::Add(hn::Mul(ax, bx), hn::Mul(ay, by)), constant(begin.z() * end.z()));
    // On the line of an edge that lies in the plane, the cosine is the limit from the receiving side.
    const auto tilt = hn::IfThenElse(hn::Gt(sine, hn::Zero(DoubleTag())), hn::Div(nz, sine), constant(1));
    return hn::Mul(angle_of(sine, cosine), tilt);
}

double sum(const PlanePoints& points, const Polygon& polygon) {
    const DoubleTag d;
    Columns columns;
    for (std::size_t i = 0; i < points.size; i += row) {
        for (std::size_t k = 0; k < vectors; ++k) {
            const std::size_t at = i + k * lanes;
            const auto x = hn::Load(d, &points.x[at]);
            const auto y = hn::Load(d, &points.y[at]);
            auto factor = hn::Zero(d);
            for (std::size_t vertex = 0; vertex < polygon.size(); ++vertex) {
                factor = hn::Add(factor, edge_term(x, y, polygon[vertex], next_corner(polygon, vertex)));
            }
            // Seen from behind, the vertices run the other way round.
            factor = hn::Max(factor, hn::Zero(d));
            columns.add(k, hn::Mul(factor, hn::Load(d, &points.weight[at])));
        }
    }
    return columns.total() * (0.5 / std::numbers::pi);
}

}  // namespace HWY_NAMESPACE
}  // namespace ff
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ff {

HWY_EXPORT(sum);

Polygon clip_at_horizon(const Polygon& polygon) {
    Polygon above = part_above(polygon, [](const Eigen::Vector3d& vertex) { return vertex.z(); });
    // A vertex that was made where an edge crosses the plane lies in the plane, whatever rounding says.
    for (Eigen::Vector3d& vertex : above) {
        const bool is_crossing = std::find(polygon.begin(), polygon.end(), vertex) == polygon.end();
        if (is_crossing) vertex.z() = 0;
    }
    return above;
}

double sum_polygon_factors(const PlanePoints& points, const Polygon& polygon) {
    FF_EXPECT(points.size % 8 == 0 && points.size <= block_capacity);
    FF_EXPECT(std::all_of(polygon.begin(), polygon.end(), [](const auto& vertex) { return vertex.z() >= 0; }));
    return HWY_DYNAMIC_DISPATCH(sum)(points, polygon);
}

}  // namespace ff
#endif  // HWY_ONCE
