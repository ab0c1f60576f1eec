#include "samplers/nets/faure_in_base.hpp"

#include "samplers/nets/faure_digits.hpp"
#include "samplers/support/philox_block.hpp"
#include "samplers/support/sizes.hpp"

#include <algorithm>

namespace ff::samplers {
namespace {

/// The most digits of which all values fit 32 bits; more are drawn, not computed.
template <std::uint32_t base>
constexpr std::size_t max_computed_digits = [] {
    std::size_t digits = 0;
    for (std::uint64_t size = base; size < max_points; size *= base) ++digits;
    return digits;
}();

/// Key of the permutations of one coordinate.
struct NodeKey {
    std::uint32_t addend = 0;
    std::uint32_t mask = 0;
};

/// The random word of a node: lowbias32 [wellons2018], a bijection, with one key before and one within.
std::uint32_t node_word(std::uint32_t node, const NodeKey& key) {
    std::uint32_t x = node + key.addend;
    x = ((x ^ x >> 16) * 0x7feb352du) ^ key.mask;
    x = (x ^ x >> 15) * 0x846ca68bu;
    return x ^ x >> 16;
}

/// (factor * digit + offset) mod base: one of the base * (base - 1) affine permutations, each with probability 1 over
/// their number, to 2^-32.
template <std::uint32_t base>
std::uint32_t permute(std::uint32_t digit, std::uint32_t word) {
    const auto choice = static_cast<std::uint32_t>(std::uint64_t{word} * base * (base - 1) >> 32);
    return ((1 + choice / base) * digit + choice % base) % base;
}

/// The first digits, scrambled, as one integer. The nodes of the tree are numbered as in faure.cpp: the root is 0, the
/// children of n are base * n + 1 and following.
template <std::uint32_t base>
std::uint32_t scramble_digits(const FaureDigits& digits, std::size_t count, const NodeKey& key) {
    std::uint32_t value = 0;
    std::uint32_t node = 0;
    for (std::size_t j = 0; j < count; ++j) {
        value = value * base + permute<base>(digits[j], node_word(node, key));
        node = node * base + digits[j] + 1;
    }
    return value;
}

}  // namespace

template <std::uint32_t base>
FaureInBase<base>::FaureInBase(const PointSetSpec& spec)
    : digits_(std::min<std::size_t>(count_digits(spec.points, base), max_computed_digits<base>)) {}

template <std::uint32_t base>
void FaureInBase<base>::fill(const Stream& stream, PointIndex first, PointBlock& block) const {
    philox_block(stream, Purpose::coordinates, first, block);  // the places within the last cells
    const Words addends = philox(stream, 0, Purpose::scramble);
    const Words masks = philox(stream, 1, Purpose::scramble);
    const std::uint64_t width = reciprocal(integer_power(base, digits_));
    for (std::size_t d = 0; d < block.dimension; ++d) {
        const NodeKey key{addends[d], masks[d]};
        FaureDigits digits{};
        for (std::size_t i = 0; i < block.size; ++i) {
            // From an index to the next only the lowest digit changes, and with it the first of the coordinate.
            const PointIndex index = first + i;
            if (i == 0 || index % base == 0) {
                digits = faure_digits<base>(index, d);
            } else {
                digits[0] = digits[0] + 1 == base ? 0 : digits[0] + 1;
            }
            std::uint32_t& x = block.coordinate[d][i];
            x = place_in_cell(scramble_digits<base>(digits, digits_, key), width, x);
        }
    }
}

template class FaureInBase<7>;
template class FaureInBase<11>;
template class FaureInBase<13>;

}  // namespace ff::samplers
