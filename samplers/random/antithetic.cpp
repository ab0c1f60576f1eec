#include "samplers/random/antithetic.hpp"

namespace ff::samplers {

void mirror_points(const PointBlock& originals, std::size_t skip, PointBlock& block) {
    for (std::size_t d = 0; d < block.dimension; ++d) {
        for (std::size_t i = 0; i < block.size; ++i) {
            const std::uint32_t original = originals.coordinate[d][(i + skip) / 2];
            block.coordinate[d][i] = (i + skip) % 2 == 0 ? original : ~original;
        }
    }
}

}  // namespace ff::samplers
