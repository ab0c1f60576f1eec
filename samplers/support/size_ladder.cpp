#include "samplers/support/size_ladder.hpp"

#include "core/support/contract.hpp"
#include "samplers/support/sizes.hpp"

#include <algorithm>
#include <bit>
#include <iterator>

namespace ff::samplers {
namespace {

/// The smallest size of at least `points` that the sampler is made for.
std::uint64_t next_size(const SamplerInfo& info, std::uint64_t points, std::size_t dimension) {
    switch (info.sizes) {
        case Sizes::powers: {
            std::uint64_t size = info.multiple;
            while (size < points) size *= info.base;
            return size;
        }
        case Sizes::fourth_power:
            return integer_power(floor_root(points - 1, dimension) + 1, dimension);
        case Sizes::any:
        case Sizes::nodes:
            break;
    }
    return std::bit_ceil(points);
}

}  // namespace

std::vector<std::uint64_t> size_ladder(const SamplerInfo& info, std::uint64_t low, std::uint64_t high,
                                       std::size_t dimension) {
    FF_EXPECT(1 <= low && low <= high && high <= max_points && info.sizes != Sizes::nodes);
    std::vector<std::uint64_t> sizes;
    if (!info.at_hand.empty()) {
        std::copy_if(info.at_hand.begin(), info.at_hand.end(), std::back_inserter(sizes),
                     [&](std::uint64_t size) { return low <= size && size <= high; });
        return sizes;
    }
    for (std::uint64_t octave = std::bit_floor(low); octave <= high; octave *= 2) {
        const std::uint64_t size = next_size(info, std::max(octave, low), dimension);
        if (size < 2 * octave && size <= high) sizes.push_back(size);
    }
    return sizes;
}

}  // namespace ff::samplers
