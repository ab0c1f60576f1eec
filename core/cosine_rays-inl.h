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

#include <cstdint>

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

/// The coordinate's upper 24 bits, made odd: (0, 2^24), exact as float and symmetric, u -> 1 - u included. Never 0 or
/// 2^24, so that no ray is undefined and none starts between two patches.
HWY_INLINE Floats odd_24_bits(Words32 word) {
    const WordTag dw;
    const auto odd = hn::Or(hn::ShiftRight<8>(word), hn::Set(dw, 1));
    return hn::ConvertTo(FloatTag(), hn::BitCast(IntegerTag(), odd));
}

/// Surface coordinate in [0, 1] of a point of a patch; `first` and `scale` are those of PatchMap.
HWY_INLINE Floats surface_coordinate(Words32 word, float first, float scale) {
    const FloatTag df;
    return hn::Mul(hn::Add(hn::Set(df, first), odd_24_bits(word)), hn::Set(df, scale));
}

/// True where the top bit is set.
HWY_INLINE FloatMask top_bit(Words32 word) {
    const IntegerTag di;
    return hn::RebindMask(FloatTag(), hn::Lt(hn::BitCast(di, word), hn::Zero(di)));
}

/// A direction in the frame of the surface that it leaves, of length between 2^12 and 2^24: absolute values of its
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
    const IntegerTag di;
    const auto sin2 = odd_24_bits(x);
    const auto normal = hn::Sub(hn::Set(df, 0x1p24f), sin2);
    const auto radius = hn::Sqrt(hn::Mul(sin2, normal));

    // The angle in turns is turn * 2^-32. Its distance to the nearest quarter turn, in quarters: q in (-1/2, 1/2),
    // never 0 because the 24-bit angle is odd.
    const auto turn = hn::And(hn::Or(y, hn::Set(dw, 0x100)), hn::Set(dw, 0xffffff00u));
    const auto quarters = hn::ConvertTo(df, hn::BitCast(di, hn::ShiftLeft<2>(turn)));
    const auto q = hn::Mul(hn::Abs(quarters), hn::Set(df, 0x1p-32f));
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
    const auto small = hn::Mul(radius, sine);
    const auto large = hn::Mul(radius, cosine);

    // Nearest quarter turn odd (second bit after rounding): cosine and sine change places.
    const auto odd = top_bit(hn::ShiftLeft<1>(hn::Add(turn, hn::Set(dw, 0x20000000u))));
    return {.size_u = hn::IfThenElse(odd, small, large),
            .size_v = hn::IfThenElse(odd, large, small),
            .normal = normal,
            .negative_u = top_bit(hn::Add(turn, hn::Set(dw, 0x40000000u))),
            .negative_v = top_bit(turn)};
}

}  // namespace HWY_NAMESPACE
}  // namespace ff
HWY_AFTER_NAMESPACE();

#endif  // FF_CORE_COSINE_RAYS_INL_H_
