// Angles from sines and cosines, the same to the bit on every CPU: included once for each instruction set by the files
// that need it.

#if defined(FF_CORE_ARC_ANGLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FF_CORE_ARC_ANGLE_INL_H_
#undef FF_CORE_ARC_ANGLE_INL_H_
#else
#define FF_CORE_ARC_ANGLE_INL_H_
#endif

#include "core/geometry/unit_circle.hpp"
#include "core/support/double_rows-inl.h"

#include <cstddef>
#include <numbers>

HWY_BEFORE_NAMESPACE();
namespace ff {
namespace HWY_NAMESPACE {

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

}  // namespace HWY_NAMESPACE
}  // namespace ff
HWY_AFTER_NAMESPACE();

#endif  // FF_CORE_ARC_ANGLE_INL_H_
