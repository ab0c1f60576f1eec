// owen_hash.hpp lane by lane, vectorised: included once for each instruction set by the samplers that need it.

#if defined(FF_SAMPLERS_OWEN_HASH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FF_SAMPLERS_OWEN_HASH_INL_H_
#undef FF_SAMPLERS_OWEN_HASH_INL_H_
#else
#define FF_SAMPLERS_OWEN_HASH_INL_H_
#endif

#include "samplers/support/owen_hash.hpp"

#include <hwy/highway.h>

#include <array>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace ff::samplers {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Lanes32 = hn::CappedTag<std::uint32_t, 16>;
using Lanes8 = hn::Repartition<std::uint8_t, Lanes32>;
using Vec32 = hn::Vec<Lanes32>;

/// `reverse_bits`: the bits of each byte by two tables of nibbles, then the bytes of each word.
HWY_INLINE Vec32 reverse_bits_of(Vec32 x) {
    alignas(16) static constexpr std::array<std::uint8_t, 16> reversed_low{
        0x00, 0x80, 0x40, 0xc0, 0x20, 0xa0, 0x60, 0xe0, 0x10, 0x90, 0x50, 0xd0, 0x30, 0xb0, 0x70, 0xf0};
    alignas(16) static constexpr std::array<std::uint8_t, 16> reversed_high{0x0, 0x8, 0x4, 0xc, 0x2, 0xa, 0x6, 0xe,
                                                                            0x1, 0x9, 0x5, 0xd, 0x3, 0xb, 0x7, 0xf};
    alignas(16) static constexpr std::array<std::uint8_t, 16> reversed_bytes{3,  2,  1, 0, 7,  6,  5,  4,
                                                                             11, 10, 9, 8, 15, 14, 13, 12};
    const Lanes32 d;
    const Lanes8 bytes;
    const auto nibble = hn::Set(d, 0x0f0f0f0fu);
    const auto low = hn::BitCast(bytes, hn::And(x, nibble));
    const auto high = hn::BitCast(bytes, hn::And(hn::ShiftRight<4>(x), nibble));
    const auto reversed = hn::Or(hn::TableLookupBytes(hn::LoadDup128(bytes, reversed_low.data()), low),
                                 hn::TableLookupBytes(hn::LoadDup128(bytes, reversed_high.data()), high));
    return hn::BitCast(d, hn::TableLookupBytes(reversed, hn::LoadDup128(bytes, reversed_bytes.data())));
}

HWY_INLINE Vec32 xor_multiple(Vec32 x, std::uint32_t multiplier) {
    return hn::Xor(x, hn::Mul(x, hn::Set(Lanes32(), multiplier)));
}

/// `owen_hash`.
HWY_INLINE Vec32 owen_hash_of(Vec32 x, OwenSeed seed) {
    const Lanes32 d;
    x = xor_multiple(x, OwenHash::first);
    x = hn::Add(x, hn::Set(d, seed.addend));
    x = hn::Mul(x, hn::Set(d, seed.multiplier | 1u));
    x = xor_multiple(x, OwenHash::second);
    return xor_multiple(x, OwenHash::third);
}

}  // namespace HWY_NAMESPACE
}  // namespace ff::samplers
HWY_AFTER_NAMESPACE();

#endif
