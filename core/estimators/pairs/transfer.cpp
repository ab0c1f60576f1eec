#include "core/estimators/pairs/transfer.hpp"

#include "core/support/contract.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/estimators/pairs/transfer.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h comes first
#include "core/support/double_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ff {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct Vectors3 {
    Doubles x, y, z;
};

HWY_INLINE Doubles dot(const Vectors3& a, const Eigen::Vector3d& b) {
    return hn::Add(hn::Add(hn::Mul(a.x, constant(b.x())), hn::Mul(a.y, constant(b.y()))),
                   hn::Mul(a.z, constant(b.z())));
}

/// weight * cos_from * cos_to / r^2 = weight * (n_from . d / r^2) * (-n_to . d / r^2)
HWY_INLINE Doubles transfer(const Vectors3& d, Doubles weight, const Normals& normals) {
    const auto zero = hn::Zero(DoubleTag());
    const auto r2 = hn::Add(hn::Add(hn::Mul(d.x, d.x), hn::Mul(d.y, d.y)), hn::Mul(d.z, d.z));
    const auto inverse = hn::IfThenElseZero(hn::Gt(r2, zero), hn::Div(constant(1), r2));
    const auto leaving = hn::Mul(hn::Max(dot(d, normals.from), zero), inverse);
    const auto arriving = hn::Mul(hn::Min(dot(d, normals.to), zero), inverse);
    return hn::Mul(hn::Mul(leaving, hn::Neg(arriving)), weight);
}

double sum(const Separations& pairs, std::span<const Eigen::Vector3d> offsets, const Normals& normals,
           std::span<double> each) {
    const DoubleTag dd;
    Columns columns;
    for (std::size_t o = 0; o < offsets.size(); ++o) {
        const Eigen::Vector3d& offset = offsets[o];
        Columns own;  // sums for this offset
        for (std::size_t i = 0; i < pairs.size; i += row) {
            for (std::size_t k = 0; k < vectors; ++k) {
                const std::size_t at = i + k * lanes;
                const Vectors3 d{hn::Add(hn::Load(dd, &pairs.x[at]), constant(offset.x())),
                                 hn::Add(hn::Load(dd, &pairs.y[at]), constant(offset.y())),
                                 hn::Add(hn::Load(dd, &pairs.z[at]), constant(offset.z()))};
                const auto term = transfer(d, hn::Load(dd, &pairs.weight[at]), normals);
                columns.add(k, term);
                own.add(k, term);
            }
        }
        if (!each.empty()) each[o] += own.total();
    }
    return columns.total();
}

void separate_block(const Parallelogram& from, const Parallelogram& to, const WeightedBlock& points,
                    Separations& pairs) {
    const DoubleTag dd;
    const std::array components{&pairs.x, &pairs.y, &pairs.z};
    for (std::size_t i = 0; i < points.size; i += lanes) {
        const auto u = [&](std::size_t d) HWY_ATTR { return hn::Load(dd, &points.coordinate[d][i]); };
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            const auto begin =
                hn::Add(hn::Mul(u(0), constant(from.edge_u[axis])), hn::Mul(u(1), constant(from.edge_v[axis])));
            const auto end =
                hn::Add(hn::Mul(u(2), constant(to.edge_u[axis])), hn::Mul(u(3), constant(to.edge_v[axis])));
            hn::Store(hn::Sub(end, begin), dd, &(*components[static_cast<std::size_t>(axis)])[i]);
        }
        hn::Store(hn::Load(dd, &points.weight[i]), dd, &pairs.weight[i]);
    }
    pairs.size = (points.size + row - 1) / row * row;
    for (std::size_t i = points.size; i < pairs.size; ++i) {
        pairs.x[i] = pairs.y[i] = pairs.z[i] = pairs.weight[i] = 0;
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace ff
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ff {

HWY_EXPORT(sum);
HWY_EXPORT(separate_block);

void separate(const Parallelogram& from, const Parallelogram& to, const WeightedBlock& points, Separations& pairs) {
    FF_EXPECT(points.dimension == 4);
    FF_EXPECT(points.size <= block_capacity);
    HWY_DYNAMIC_DISPATCH(separate_block)(from, to, points, pairs);
}

double sum_transfer(const Separations& pairs, std::span<const Eigen::Vector3d> offsets, const Normals& normals,
                    std::span<double> each) {
    FF_EXPECT(each.empty() || each.size() == offsets.size());
    return HWY_DYNAMIC_DISPATCH(sum)(pairs, offsets, normals, each);
}

}  // namespace ff
#endif  // HWY_ONCE
