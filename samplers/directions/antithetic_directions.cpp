#include "samplers/directions/antithetic_directions.hpp"

namespace ff::samplers {

void AntitheticDirections::fill(const Stream& stream, PointIndex first, PointBlock& block) const {
    if (block.size == 0) return;
    PointBlock originals;
    originals.dimension = block.dimension;
    originals.size = (first + block.size - 1) / 2 - first / 2 + 1;
    random_.fill(stream, first / 2, originals);
    constexpr std::uint32_t half_turn = 1u << 31;
    for (std::size_t d = 0; d < block.dimension; ++d) {
        const std::uint32_t turn = d + 1 == block.dimension ? half_turn : 0;
        for (std::size_t i = 0; i < block.size; ++i) {
            const std::size_t place = first % 2 + i;
            block.coordinate[d][i] = originals.coordinate[d][place / 2] + (place % 2 == 1 ? turn : 0);
        }
    }
}

}  // namespace ff::samplers
