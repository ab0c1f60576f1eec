#include "tests/support/owen_tree.hpp"

#include "samplers/sobol_directions.hpp"

namespace ff::test {

std::uint32_t nested_uniform(std::uint32_t coordinate, const Stream& stream, std::size_t dimension) {
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

void fill_sobol_tree(const Stream& stream, PointIndex first, PointBlock& block) {
    for (std::size_t d = 0; d < block.dimension; ++d) {
        for (std::size_t i = 0; i < block.size; ++i) {
            const auto index = static_cast<std::uint32_t>(first + i);
            block.coordinate[d][i] = nested_uniform(samplers::sobol_coordinate(index, d), stream, d);
        }
    }
}

}  // namespace ff::test
