#include "samplers/random/random.hpp"

#include "samplers/support/philox_block.hpp"

namespace ff::samplers {

void Random::fill(const Stream& stream, PointIndex first, PointBlock& block) const {
    philox_block(stream, Purpose::coordinates, first, block);
}

}  // namespace ff::samplers
