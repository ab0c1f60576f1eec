#include "samplers/antithetic.hpp"

namespace ff::samplers {

void Antithetic::fill(const Stream& stream, PointIndex first, PointBlock& block) const {
    if (block.size == 0) return;
    PointBlock originals;
    originals.dimension = block.dimension;
    originals.size = (first + block.size - 1) / 2 - first / 2 + 1;
    random_.fill(stream, first / 2, originals);
    for (std::size_t d = 0; d < block.dimension; ++d) {
        for (std::size_t i = 0; i < block.size; ++i) {
            const PointIndex index = first + i;
            const std::uint32_t original = originals.coordinate[d][index / 2 - first / 2];
            block.coordinate[d][i] = index % 2 == 0 ? original : ~original;
        }
    }
}

}  // namespace ff::samplers
