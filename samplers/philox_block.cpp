#include "samplers/philox_block.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "samplers/philox_block.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which compiles this file once for every instruction set.
#include <hwy/highway.h>

#ifndef FF_SAMPLERS_PHILOX_BLOCK_ONCE
#define FF_SAMPLERS_PHILOX_BLOCK_ONCE
namespace ff::samplers {

/// Philox4x32 [salmon2011]: the two multipliers, and what the two words of the key grow by in every round.
struct Philox {
    static constexpr int rounds = 10;
    static constexpr std::uint32_t multiplier0 = 0xD2511F53;
    static constexpr std::uint32_t multiplier1 = 0xCD9E8D57;
    static constexpr std::uint32_t weyl0 = 0x9E3779B9;
    static constexpr std::uint32_t weyl1 = 0xBB67AE85;
};

}  // namespace ff::samplers
#endif

HWY_BEFORE_NAMESPACE();
namespace ff::samplers {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Lanes32 = hn::ScalableTag<std::uint32_t>;
using Vec32 = hn::Vec<Lanes32>;

/// One counter block per 64-bit lane. Only the low half of each lane counts: the 32x32->64 multiplication reads nothing
/// else, so its products need no blending, and the high half of a product is fetched by swapping the halves.
struct Counters {
    Vec32 word0, word1, word2, word3;
};

/// The products of `multiplier` with the low halves.
HWY_INLINE Vec32 multiply(Vec32 word, std::uint32_t multiplier) {
    const Lanes32 d;
    return hn::BitCast(d, hn::MulEven(word, hn::Set(d, multiplier)));
}

HWY_INLINE Counters next_round(const Counters& c, std::uint32_t key0, std::uint32_t key1) {
    const Lanes32 d;
    const Vec32 product0 = multiply(c.word0, Philox::multiplier0);
    const Vec32 product1 = multiply(c.word2, Philox::multiplier1);
    return {hn::Xor3(hn::Shuffle2301(product1), c.word1, hn::Set(d, key0)), product1,
            hn::Xor3(hn::Shuffle2301(product0), c.word3, hn::Set(d, key1)), product0};
}

/// Words in point order from the lanes of even points and the lanes of odd points.
HWY_INLINE void store_joined(Vec32 even, Vec32 odd, std::uint32_t* HWY_RESTRICT out) {
    hn::StoreU(hn::OddEven(hn::Shuffle2301(odd), even), Lanes32(), out);
}

void philox_block_impl(const Stream& stream, Purpose purpose, std::uint32_t first, PointBlock& block) {
    const Lanes32 d;
    const std::size_t lanes = hn::Lanes(d);
    const Vec32 word1 = hn::Set(d, stream.trial);
    const Vec32 word2 = hn::Set(d, stream.source);
    const Vec32 word3 = hn::Set(d, stream.target << 8 | static_cast<std::uint32_t>(purpose));

    for (std::size_t i = 0; i < block.size; i += lanes) {
        const Vec32 index = hn::Iota(d, first + static_cast<std::uint32_t>(i));
        Counters even{index, word1, word2, word3};
        Counters odd{hn::Shuffle2301(index), word1, word2, word3};
        std::uint32_t key0 = stream.key.word0;
        std::uint32_t key1 = stream.key.word1;
        for (int round = 0; round < Philox::rounds; ++round) {
            even = next_round(even, key0, key1);
            odd = next_round(odd, key0, key1);
            key0 += Philox::weyl0;
            key1 += Philox::weyl1;
        }
        auto& out = block.coordinate;
        store_joined(even.word0, odd.word0, &out[0][i]);
        if (block.dimension > 1) store_joined(even.word1, odd.word1, &out[1][i]);
        if (block.dimension > 2) store_joined(even.word2, odd.word2, &out[2][i]);
        if (block.dimension > 3) store_joined(even.word3, odd.word3, &out[3][i]);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace ff::samplers
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ff::samplers {

HWY_EXPORT(philox_block_impl);

void philox_block(const Stream& stream, Purpose purpose, PointIndex first, PointBlock& block) {
    HWY_DYNAMIC_DISPATCH(philox_block_impl)(stream, purpose, static_cast<std::uint32_t>(first), block);
}

}  // namespace ff::samplers
#endif
