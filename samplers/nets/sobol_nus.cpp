#include "samplers/nets/sobol_nus.hpp"

#include "samplers/nets/sobol_directions.hpp"

namespace ff::samplers {
namespace {

std::uint32_t scramble_coordinate(std::uint32_t coordinate, const Stream& stream, std::size_t dimension) {
    std::uint32_t result = 0;
    for (unsigned depth = 0; depth < 32; ++depth) {
        // A leading 1 before the digits above makes the number of a node unique over all depths.
        const std::uint32_t node = depth == 0 ? 1 : 1u << depth | coordinate >> (32 - depth);
        const std::uint32_t swap = philox(stream, node, Purpose::permutation)[dimension] >> 31;
        const std::uint32_t digit = coordinate >> (31 - depth) & 1u;
        result = result << 1 | (digit ^ swap);
    }
    return result;
}

}  // namespace

void SobolNus::fill(const Stream& stream, PointIndex first, PointBlock& block) const {
    for (std::size_t d = 0; d < block.dimension; ++d) {
        for (std::size_t i = 0; i < block.size; ++i) {
            block.coordinate[d][i] =
                scramble_coordinate(sobol_coordinate(static_cast<std::uint32_t>(first + i), d), stream, d);
        }
    }
}

}  // namespace ff::samplers
