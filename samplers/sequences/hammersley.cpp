#include "samplers/sequences/hammersley.hpp"

#include "samplers/support/sizes.hpp"

#include <algorithm>

namespace ff::samplers {

void Hammersley::fill(const Stream& stream, PointIndex first, PointBlock& block) const {
    const std::size_t grid = block.dimension < 2 ? 0 : block.dimension - 2;
    if (block.dimension > 1) {
        PointBlock inverses;
        inverses.dimension = block.dimension - 1;
        inverses.size = block.size;
        halton_.fill(stream, first, inverses);
        for (std::size_t d = 0; d < inverses.dimension; ++d) {
            const std::size_t to = d == 0 ? block.dimension - 1 : d - 1;
            std::copy_n(inverses.coordinate[d].begin(), block.size, block.coordinate[to].begin());
        }
    }
    const Words shift = philox(stream, 0, Purpose::scramble);
    const std::uint64_t step = points_ < 2 ? 0 : reciprocal(points_);
    std::uint64_t x = (std::uint64_t{shift[0]} << 32 | shift[1]) + first * step;  // modulo 1
    for (std::size_t i = 0; i < block.size; ++i, x += step)
        block.coordinate[grid][i] = static_cast<std::uint32_t>(x >> 32);
}

}  // namespace ff::samplers
