#include "samplers/sequences/lattice.hpp"

#include "samplers/support/owen_hash.hpp"

namespace ff::samplers {

void Lattice::fill(const Stream& stream, PointIndex first, PointBlock& block) const {
    const Words shift = philox(stream, 0, Purpose::scramble);
    for (std::size_t i = 0; i < block.size; ++i) {
        const std::uint32_t radical_inverse = reverse_bits(static_cast<std::uint32_t>(first + i));
        for (std::size_t d = 0; d < block.dimension; ++d) {
            block.coordinate[d][i] = radical_inverse * generating_vector[d] + shift[d];
        }
    }
}

}  // namespace ff::samplers
