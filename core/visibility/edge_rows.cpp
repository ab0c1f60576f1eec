#include "core/visibility/edge_rows.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/visibility/edge_rows.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h comes first
#include "core/support/double_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ff {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct Vectors {
    Doubles x, y, z;
};

HWY_INLINE Vectors load(EdgeTable<const double> columns, int column, std::size_t k) {
    const DoubleTag d;
    return {hn::LoadU(d, columns.at(column, k)), hn::LoadU(d, columns.at(column + 1, k)),
            hn::LoadU(d, columns.at(column + 2, k))};
}

HWY_INLINE Vectors constants(const Eigen::Vector3d& v) {
    return {constant(v.x()), constant(v.y()), constant(v.z())};
}

HWY_INLINE void store(const Vectors& v, EdgeTable<double> columns, int column, std::size_t k) {
    const DoubleTag d;
    hn::StoreU(v.x, d, columns.at(column, k));
    hn::StoreU(v.y, d, columns.at(column + 1, k));
    hn::StoreU(v.z, d, columns.at(column + 2, k));
}

HWY_INLINE Vectors difference(const Vectors& a, const Vectors& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

HWY_INLINE Doubles dot(const Vectors& a, const Vectors& b) {
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

HWY_INLINE Vectors cross(const Vectors& a, const Vectors& b) {
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
            hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

HWY_INLINE Doubles sizes(const Vectors& v) {
    return hn::Add(hn::Add(hn::Abs(v.x), hn::Abs(v.y)), hn::Abs(v.z));
}

void see(EdgeTable<const double> edges, const Eigen::Vector3d& place, double rounding,
         const TargetVectors& target_corners, const TargetVectors& target_sides, EdgeTable<double> result) {
    const DoubleTag d;
    const auto zero = hn::Zero(d);
    for (std::size_t k = 0; k < edges.rows; k += lanes) {
        const auto side = hn::LoadU(d, result.at(seen_edge::side, k));
        if (hn::AllTrue(d, hn::Eq(side, zero))) continue;
        const Vectors a = difference(load(edges, edge_ends::ax, k), constants(place));
        const Vectors b = difference(load(edges, edge_ends::bx, k), constants(place));
        Vectors normal = cross(b, a);
        normal = {hn::Mul(normal.x, side), hn::Mul(normal.y, side), hn::Mul(normal.z, side)};
        const auto a_size = sizes(a);
        const auto b_size = sizes(b);
        const auto by_distance = hn::Mul(hn::Add(a_size, b_size), constant(rounding));
        const auto fixed = hn::Mul(hn::Mul(a_size, b_size), constant(rounding));
        auto reach_inside = zero;
        auto reach_outside = zero;
        for (const TargetVector& target : target_corners) {
            const auto height = dot(normal, constants(target.vector));
            const auto room = hn::Add(hn::Mul(by_distance, constant(target.length)), fixed);
            reach_inside = hn::Max(reach_inside, hn::IfThenElseZero(hn::Gt(height, room), constant(reaches_inside)));
            reach_outside =
                hn::Max(reach_outside, hn::IfThenElseZero(hn::Lt(height, hn::Neg(room)), constant(reaches_outside)));
        }
        auto beyond = zero;
        double bit = first_beyond;
        for (const TargetVector& target : target_sides) {
            const auto height = dot(a, constants(target.vector));
            beyond = hn::Add(beyond, hn::IfThenElseZero(hn::Le(height, zero), constant(bit)));
            bit *= 2;
        }
        store(a, result, seen_edge::ax, k);
        store(normal, result, seen_edge::nx, k);
        hn::StoreU(by_distance, d, result.at(seen_edge::by_distance, k));
        hn::StoreU(fixed, d, result.at(seen_edge::fixed, k));
        hn::StoreU(hn::Add(hn::Add(reach_inside, reach_outside), beyond), d, result.at(seen_edge::position, k));
    }
}

void cover(EdgeTable<const double> edges, std::span<const SeenEdge> cuts, std::span<const std::uint32_t> ends,
           EdgeTable<double> result) {
    const DoubleTag d;
    const auto zero = hn::Zero(d);
    const auto one = constant(1);
    for (std::size_t k = 0; k < edges.rows; k += lanes) {
        const Vectors a = load(edges, outline_edge::ax, k);
        const Vectors b = load(edges, outline_edge::bx, k);
        const Vectors normal = load(edges, outline_edge::nx, k);
        const auto by_distance = hn::LoadU(d, edges.at(outline_edge::by_distance, k));
        const auto fixed = hn::LoadU(d, edges.at(outline_edge::fixed, k));
        const auto rank = hn::LoadU(d, edges.at(outline_edge::rank, k));
        const auto a_size = sizes(a);
        const auto b_size = sizes(b);
        const auto is_near = [&](Doubles height, Doubles slope, Doubles size, Doubles least)
                                 HWY_ATTR { return hn::Le(hn::Abs(height), hn::Add(hn::Mul(slope, size), least)); };
        std::size_t c = 0;
        for (std::size_t polygon = 0; polygon < ends.size(); ++polygon) {
            const auto is_lower = hn::Lt(constant(static_cast<double>(polygon)), rank);
            auto from = zero;
            auto to = one;
            for (; c < ends[polygon]; ++c) {
                const SeenEdge& cut = cuts[c];
                const Vectors cut_normal = constants(cut.normal);
                const Vectors cut_a = constants(cut.a);
                const Vectors cut_b = constants(cut.b);
                const auto cut_by_distance = constant(cut.by_distance);
                const auto cut_fixed = constant(cut.fixed);
                const auto at_a = dot(cut_normal, a);
                const auto at_b = dot(cut_normal, b);
                const auto ends_in_cut = hn::And(is_near(at_a, cut_by_distance, a_size, cut_fixed),
                                                 is_near(at_b, cut_by_distance, b_size, cut_fixed));
                const auto cut_ends_in_it = hn::And(is_near(dot(normal, cut_a), by_distance, sizes(cut_a), fixed),
                                                    is_near(dot(normal, cut_b), by_distance, sizes(cut_b), fixed));
                const auto same_line = hn::Or(ends_in_cut, cut_ends_in_it);
                const auto inside_line = hn::And(is_lower, hn::Gt(dot(normal, cut_normal), zero));
                const auto crossing = hn::Div(at_a, hn::Sub(at_a, at_b));
                auto begin = hn::IfThenElse(hn::Gt(at_b, zero), crossing, constant(2));
                begin = hn::IfThenElse(hn::Lt(at_a, zero), begin, zero);
                auto end = hn::IfThenElse(hn::Gt(at_a, zero), crossing, constant(-1));
                end = hn::IfThenElse(hn::Lt(at_b, zero), end, one);
                begin = hn::IfThenElse(same_line, hn::IfThenElse(inside_line, zero, constant(2)), begin);
                end = hn::IfThenElse(same_line, hn::IfThenElse(inside_line, one, constant(-1)), end);
                from = hn::Max(from, begin);
                to = hn::Min(to, end);
            }
            hn::StoreU(from, d, result.at(static_cast<int>(2 * polygon), k));
            hn::StoreU(to, d, result.at(static_cast<int>(2 * polygon + 1), k));
        }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace ff
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ff {

HWY_EXPORT(see);
HWY_EXPORT(cover);

void see_edges(EdgeTable<const double> edges, const Eigen::Vector3d& place, double rounding,
               const TargetVectors& target_corners, const TargetVectors& target_sides, EdgeTable<double> result) {
    HWY_DYNAMIC_DISPATCH(see)(edges, place, rounding, target_corners, target_sides, result);
}

void cover_edges(EdgeTable<const double> edges, std::span<const SeenEdge> cuts, std::span<const std::uint32_t> ends,
                 EdgeTable<double> result) {
    HWY_DYNAMIC_DISPATCH(cover)(edges, cuts, ends, result);
}

}  // namespace ff
#endif  // HWY_ONCE
