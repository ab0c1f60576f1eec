#include "samplers/padded.hpp"

#include "samplers/owen_hash.hpp"

namespace ff::samplers {
namespace {

/// Coordinate 1 of Sobol' with the bits reversed: bit b is the sum of all bits k of the index for which binomial(k, b)
/// is odd, i.e. for which the binary digits of b are among those of k.
constexpr std::uint32_t multiply_pascal(std::uint32_t index) {
    index ^= index >> 16 & 0x0000ffffu;
    index ^= index >> 8 & 0x00ff00ffu;
    index ^= index >> 4 & 0x0f0f0f0fu;
    index ^= index >> 2 & 0x33333333u;
    index ^= index >> 1 & 0x55555555u;
    return index;
}

}  // namespace

void Padded::fill(const Stream& stream, PointIndex first, PointBlock& block) const {
    const Words addends = philox(stream, 0, Purpose::scramble);
    const Words multipliers = philox(stream, 1, Purpose::scramble);
    const Words orders = philox(stream, 2, Purpose::scramble);
    for (std::size_t d = 0; d < block.dimension; ++d) {
        const OwenSeed order{orders[d / 2], orders[2 + d / 2]};
        const OwenSeed seed{addends[d], multipliers[d]};
        for (std::size_t i = 0; i < block.size; ++i) {
            const std::uint32_t index = owen_scramble(static_cast<std::uint32_t>(first + i), order);
            const std::uint32_t reversed = d % 2 == 0 ? index : multiply_pascal(index);
            block.coordinate[d][i] = reverse_bits(owen_hash(reversed, seed));
        }
    }
}

}  // namespace ff::samplers
