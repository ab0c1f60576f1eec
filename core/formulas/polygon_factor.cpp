#include "core/formulas/polygon_factor.hpp"

#include "core/geometry/unit_circle.hpp"
#include "core/support/contract.hpp"

#include <algorithm>
#include <numbers>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/formulas/polygon_factor.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h comes first
#include "core/support/double_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ff {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Products and sums are not fused: every CPU gives the same bits.

/// atan(x) for |x| <= tan(pi/8).
HWY_INLINE Doubles small_arc_tangent(Doubles x) {
    const Doubles y = hn::Mul(x, x);
    Doubles p = constant(arc_tangent_series[0]);
    for (std::size_t k = 1; k < arc_tangent_series.size(); ++k)
        p = hn::Add(hn::Mul(p, y), constant(arc_tangent_series[k]));
    return hn::Add(x, hn::Mul(hn::Mul(x, y), p));
}

/// The angle, 0 to pi, with this sine and cosine up to a common factor. @pre sine >= 0
HWY_INLINE Doubles angle_of(Doubles sine, Doubles cosine) {
    constexpr double tan_pi_8 = std::numbers::sqrt2 - 1;
    const auto zero = hn::Zero(DoubleTag());
    const auto size = hn::Abs(cosine);
    const auto low = hn::Min(sine, size);
    const auto high = hn::Max(sine, size);
    const auto middle = hn::Gt(low, hn::Mul(high, constant(tan_pi_8)));  // beyond pi/8, measure from pi/4
    const auto numerator = hn::IfThenElse(middle, hn::Sub(low, high), low);
    const auto denominator = hn::IfThenElse(middle, hn::Add(low, high), high);
    const auto ratio = hn::IfThenElseZero(hn::Gt(high, zero), hn::Div(numerator, denominator));
    auto angle = hn::Add(small_arc_tangent(ratio), hn::IfThenElseZero(middle, constant(std::numbers::pi / 4)));
    angle = hn::IfThenElse(hn::Gt(sine, size), hn::Sub(constant(std::numbers::pi / 2), angle), angle);
    return hn::IfThenElse(hn::Lt(cosine, zero), hn::Sub(constant(std::numbers::pi), angle), angle);
}

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

HWY_INLINE Doubles dot(Doubles ax, Doubles ay, Doubles az, Doubles bx, Doubles by, Doubles bz) {
    return hn::Add(hn::Add(hn::Mul(ax, bx), hn::Mul(ay, by)), hn::Mul(az, bz));
}

void arc_terms(const Arcs& arcs, const Eigen::Vector3d& normal, double* terms) {
    const DoubleTag d;
    for (std::size_t at = 0; at < arcs.size; at += lanes) {
        const auto ax = hn::Load(d, &arcs.ax[at]);
        const auto ay = hn::Load(d, &arcs.ay[at]);
        const auto az = hn::Load(d, &arcs.az[at]);
        const auto bx = hn::Load(d, &arcs.bx[at]);
        const auto by = hn::Load(d, &arcs.by[at]);
        const auto bz = hn::Load(d, &arcs.bz[at]);
        const auto nx = hn::Sub(hn::Mul(ay, bz), hn::Mul(az, by));
        const auto ny = hn::Sub(hn::Mul(az, bx), hn::Mul(ax, bz));
        const auto nz = hn::Sub(hn::Mul(ax, by), hn::Mul(ay, bx));
        const auto sine = hn::Sqrt(dot(nx, ny, nz, nx, ny, nz));
        const auto height = dot(nx, ny, nz, constant(normal.x()), constant(normal.y()), constant(normal.z()));
        const auto tilt = hn::IfThenElseZero(hn::Gt(sine, hn::Zero(d)), hn::Div(height, sine));
        hn::StoreU(hn::Mul(angle_of(sine, dot(ax, ay, az, bx, by, bz)), tilt), d, terms + at);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace ff
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ff {

HWY_EXPORT(sum);
HWY_EXPORT(arc_terms);

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

void find_arc_terms(Arcs& arcs, const Eigen::Vector3d& normal, std::span<double> terms) {
    FF_EXPECT(terms.size() >= Arcs::capacity);
    const std::size_t size = arcs.size;
    while (arcs.size % 8 != 0) arcs.add(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
    HWY_DYNAMIC_DISPATCH(arc_terms)(arcs, normal, terms.data());
    arcs.size = size;
}

}  // namespace ff
#endif  // HWY_ONCE
