#include "core/formulas/arc_terms.hpp"

#include "core/support/contract.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/formulas/arc_terms.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h comes first
#include "core/formulas/arc_angle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ff {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Products and sums are not fused: every CPU gives the same bits.
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

HWY_EXPORT(arc_terms);

void find_arc_terms(Arcs& arcs, const Eigen::Vector3d& normal, std::span<double> terms) {
    FF_EXPECT(terms.size() >= Arcs::capacity);
    const std::size_t size = arcs.size;
    while (arcs.size % 8 != 0) arcs.add(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
    HWY_DYNAMIC_DISPATCH(arc_terms)(arcs, normal, terms.data());
    arcs.size = size;
}

}  // namespace ff
#endif  // HWY_ONCE
