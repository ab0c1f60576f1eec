// Rays from points, vectorised: included once for each instruction set by the files that need it.
//
// Only + - * sqrt, integers and fixed polynomials, in a fixed order and without MulAdd: every CPU gives the same bits.

#if defined(FF_CORE_COSINE_RAYS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FF_CORE_COSINE_RAYS_INL_H_
#undef FF_CORE_COSINE_RAYS_INL_H_
#else
#define FF_CORE_COSINE_RAYS_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ff {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::ScalableTag<float>;
using WordTag = hn::RebindToUnsigned<FloatTag>;
using IntegerTag = hn::RebindToSigned<FloatTag>;
using Floats = hn::Vec<FloatTag>;
using FloatMask = hn::Mask<FloatTag>;
using Words32 = hn::Vec<WordTag>;

/// 1 + x * 2^-23 in [1, 2), x the coordinate's upper 23 bits: put where a float has its fraction.
HWY_INLINE Floats one_plus_fraction(Words32 word) {
    const WordTag dw;
    return hn::BitCast(FloatTag(), hn::Or(hn::ShiftRight<9>(word), hn::Set(dw, 0x3f800000u)));
}

/// The middle of the 2^-23 cell, an odd multiple of 2^-24: never 0 or 1, exact and symmetric, u -> 1 - u included.
HWY_INLINE Floats coordinate(Words32 word) {
    return hn::Sub(one_plus_fraction(word), hn::Set(FloatTag(), 1 - 0x1p-24f));
}

/// Place on the surface in units of a patch: column + u, or row + u; `first` is that of PatchMap.
HWY_INLINE Floats place(Words32 word, float first) {
    return hn::Add(one_plus_fraction(word), hn::Set(FloatTag(), first));
}

/// True where the top bit is set.
HWY_INLINE FloatMask top_bit(Words32 word) {
    const IntegerTag di;
    return hn::RebindMask(FloatTag(), hn::Lt(hn::BitCast(di, word), hn::Zero(di)));
}

/// A direction in the frame of the surface that it leaves, of length between 2^-12 and 1: absolute values of its
/// tangential components, where they are negative, and the component along the normal.
struct LocalDirection {
    Floats size_u, size_v, normal;
    FloatMask negative_u, negative_v;
};

/// Malley's method: the unit disc point (sqrt(x), 2 pi y) raised to the hemisphere, (sqrt(x) cos, sqrt(x) sin,
/// sqrt(1-x)), times sqrt(1-x), which saves a square root and leaves the direction as it was.
HWY_INLINE LocalDirection cosine_direction(Words32 x, Words32 y) {
    const FloatTag df;
    const WordTag dw;
    const auto sin2 = coordinate(x);
    const auto normal = hn::Sub(hn::Set(df, 1), sin2);
    const auto radius = hn::Sqrt(hn::Mul(sin2, normal));

    // The angle in turns is y * 2^-32. An eighth of a turn further, the two top bits of `turn` number the nearest
    // quarter turn, and the others tell how far from it the angle is, in quarters: q in (-1/2, 1/2). Its last bit is
    // set, so it is never 0 and its sign is that of the angle's sine or cosine.
    const auto turn = hn::Add(y, hn::Set(dw, 0x20000000u));
    const auto fraction = hn::And(hn::ShiftRight<7>(turn), hn::Set(dw, 0x007fffffu));
    const auto q = hn::Sub(hn::BitCast(df, hn::Or(fraction, hn::Set(dw, 0x3f800001u))), hn::Set(df, 1.5f));
    // sin(q pi/2)/q and cos(q pi/2) in q^2: numpy.polynomial.Chebyshev.interpolate(f, 3, domain=[0, .25]), rounded to
    // float; absolute error below 1.4e-7 with these operations.
    const auto q2 = hn::Mul(q, q);
    auto sine = hn::Add(hn::Mul(hn::Set(df, -4.602149129e-3f), q2), hn::Set(df, 7.968021929e-2f));
    sine = hn::Add(hn::Mul(sine, q2), hn::Set(df, -6.459634900e-1f));
    sine = hn::Add(hn::Mul(sine, q2), hn::Set(df, 1.570796371f));
    sine = hn::Mul(sine, q);
    auto cosine = hn::Add(hn::Mul(hn::Set(df, -2.040815912e-2f), q2), hn::Set(df, 2.535985708e-1f));
    cosine = hn::Add(hn::Mul(cosine, q2), hn::Set(df, -1.233697057f));
    cosine = hn::Add(hn::Mul(cosine, q2), hn::Set(df, 1.0f));
    const auto small = hn::Mul(radius, hn::Abs(sine));
    const auto large = hn::Mul(radius, cosine);

    // Nearest quarter turn odd: cosine and sine change places.
    const auto odd = hn::RebindMask(df, hn::TestBit(turn, hn::Set(dw, 0x40000000u)));
    return {.size_u = hn::IfThenElse(odd, small, large),
            .size_v = hn::IfThenElse(odd, large, small),
            .normal = normal,
            .negative_u = top_bit(hn::Add(turn, hn::Set(dw, 0x20000000u))),
            .negative_v = top_bit(y)};
}

}  // namespace HWY_NAMESPACE
}  // namespace ff
HWY_AFTER_NAMESPACE();

#endif  // FF_CORE_COSINE_RAYS_INL_H_
