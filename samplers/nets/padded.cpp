#include "samplers/nets/padded.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "samplers/nets/padded.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which compiles this file once for every instruction set.
#include <hwy/highway.h>

#include "samplers/support/owen_hash-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ff::samplers {
namespace HWY_NAMESPACE {

template <int shift>
HWY_INLINE Vec32 fold(Vec32 x, std::uint32_t mask) {
    return hn::Xor(x, hn::And(hn::ShiftRight<shift>(x), hn::Set(Lanes32(), mask)));
}

/// Coordinate 1 of Sobol' with the bits reversed: bit b is the sum of all bits k of the index for which binomial(k, b)
/// is odd, i.e. for which the binary digits of b are among those of k.
HWY_INLINE Vec32 multiply_pascal(Vec32 index) {
    index = fold<16>(index, 0x0000ffffu);
    index = fold<8>(index, 0x00ff00ffu);
    index = fold<4>(index, 0x0f0f0f0fu);
    index = fold<2>(index, 0x33333333u);
    return fold<1>(index, 0x55555555u);
}

/// Two coordinates that share their order, or the first of them alone.
void fill_net(OwenSeed order, OwenSeed first_seed, OwenSeed second_seed, std::uint32_t first, std::size_t count,
              std::uint32_t* HWY_RESTRICT row, std::uint32_t* HWY_RESTRICT second_row) {
    const Lanes32 d;
    // The last vector may end past `count`; it stays within the capacity of the rows.
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const Vec32 position = hn::Iota(d, first + static_cast<std::uint32_t>(i));
        const Vec32 index = reverse_bits_of(owen_hash_of(reverse_bits_of(position), order));
        hn::StoreU(reverse_bits_of(owen_hash_of(index, first_seed)), d, row + i);
        if (second_row == nullptr) continue;
        hn::StoreU(reverse_bits_of(owen_hash_of(multiply_pascal(index), second_seed)), d, second_row + i);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace ff::samplers
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ff::samplers {

HWY_EXPORT(fill_net);

void Padded::fill(const Stream& stream, PointIndex first, PointBlock& block) const {
    const Words addends = philox(stream, 0, Purpose::scramble);
    const Words multipliers = philox(stream, 1, Purpose::scramble);
    const Words orders = philox(stream, 2, Purpose::scramble);
    for (std::size_t d = 0; d < block.dimension; d += 2) {
        std::uint32_t* const second = d + 1 < block.dimension ? block.coordinate[d + 1].data() : nullptr;
        HWY_DYNAMIC_DISPATCH(fill_net)
        ({orders[d / 2], orders[2 + d / 2]}, {addends[d], multipliers[d]}, {addends[d + 1], multipliers[d + 1]},
         static_cast<std::uint32_t>(first), block.size, block.coordinate[d].data(), second);
    }
}

}  // namespace ff::samplers
#endif
