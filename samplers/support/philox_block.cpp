#include "samplers/support/philox_block.hpp"

#include <array>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "samplers/support/philox_block.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which compiles this file once for every instruction set.
#include <hwy/highway.h>

#ifndef FF_SAMPLERS_PHILOX_BLOCK_ONCE
#define FF_SAMPLERS_PHILOX_BLOCK_ONCE
namespace ff::samplers {

/// Philox4x32 [salmon2011]: the two multipliers, and what the two words of the key grow by in every round.
struct Philox {
    static constexpr std::size_t rounds = 10;
    static constexpr std::uint32_t multiplier0 = 0xD2511F53;
    static constexpr std::uint32_t multiplier1 = 0xCD9E8D57;
    static constexpr std::uint32_t weyl0 = 0x9E3779B9;
    static constexpr std::uint32_t weyl1 = 0xBB67AE85;
};

using RoundKeys = std::array<StreamKey, Philox::rounds>;

inline RoundKeys round_keys(StreamKey key) {
    RoundKeys keys;
    for (StreamKey& round_key : keys) {
        round_key = key;
        key.word0 += Philox::weyl0;
        key.word1 += Philox::weyl1;
    }
    return keys;
}

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

HWY_INLINE Counters next_round(const Counters& c, const StreamKey& key) {
    const Lanes32 d;
    const Vec32 product0 = multiply(c.word0, Philox::multiplier0);
    const Vec32 product1 = multiply(c.word2, Philox::multiplier1);
    return {hn::Xor3(hn::Shuffle2301(product1), c.word1, hn::Set(d, key.word0)), product1,
            hn::Xor3(hn::Shuffle2301(product0), c.word3, hn::Set(d, key.word1)), product0};
}

/// Even and odd points of one vector, in lanes of their own.
struct Points {
    Counters even, odd;
};

HWY_INLINE Points first_counters(std::uint32_t first, const Words& counter) {
    const Lanes32 d;
    const Vec32 index = hn::Iota(d, first);
    const Vec32 word1 = hn::Set(d, counter[1]);
    const Vec32 word2 = hn::Set(d, counter[2]);
    const Vec32 word3 = hn::Set(d, counter[3]);
    return {{index, word1, word2, word3}, {hn::Shuffle2301(index), word1, word2, word3}};
}

template <class... Some>
HWY_INLINE void next_round(const StreamKey& key, Some&... points) {
    ((points.even = next_round(points.even, key), points.odd = next_round(points.odd, key)), ...);
}

/// Several vectors at a time hide the latency of the multiplications. Unrolled, since the first two rounds work mostly
/// on words that all points share: the compiler takes those out of the loop over points.
template <std::size_t... round, class... Some>
HWY_INLINE void apply_rounds(const RoundKeys& keys, std::index_sequence<round...> /*all*/, Some&... points) {
    (next_round(keys[round], points...), ...);
}

HWY_INLINE void store_joined(Vec32 even, Vec32 odd, std::uint32_t* HWY_RESTRICT out) {
    hn::StoreU(hn::OddEven(hn::Shuffle2301(odd), even), Lanes32(), out);
}

HWY_INLINE void store(const Points& points, std::size_t i, PointBlock& block) {
    const auto& [even, odd] = points;
    auto& out = block.coordinate;
    store_joined(even.word0, odd.word0, &out[0][i]);
    if (block.dimension > 1) store_joined(even.word1, odd.word1, &out[1][i]);
    if (block.dimension > 2) store_joined(even.word2, odd.word2, &out[2][i]);
    if (block.dimension > 3) store_joined(even.word3, odd.word3, &out[3][i]);
}

void philox_block_impl(const Stream& stream, Purpose purpose, std::uint32_t first, PointBlock& block) {
    const std::size_t lanes = hn::Lanes(Lanes32());
    const RoundKeys keys = round_keys(stream.key);
    const Words counter{0, stream.trial, stream.source, stream.target << 8 | static_cast<std::uint32_t>(purpose)};

    constexpr auto rounds = std::make_index_sequence<Philox::rounds>();
    const auto next = static_cast<std::uint32_t>(lanes);
    auto index = first;

    // The last vectors may end past `size`; they stay within the capacity.
    std::size_t i = 0;
    for (; i < block.size && i + 3 * lanes <= block_capacity; i += 3 * lanes, index += 3 * next) {
        Points low = first_counters(index, counter);
        Points middle = first_counters(index + next, counter);
        Points high = first_counters(index + 2 * next, counter);
        apply_rounds(keys, rounds, low, middle, high);
        store(low, i, block);
        store(middle, i + lanes, block);
        store(high, i + 2 * lanes, block);
    }
    for (; i < block.size; i += lanes, index += next) {
        Points last = first_counters(index, counter);
        apply_rounds(keys, rounds, last);
        store(last, i, block);
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
