#include "samplers/nets/faure.hpp"

#include "samplers/nets/faure_digits.hpp"
#include "samplers/support/philox_block.hpp"
#include "samplers/support/sizes.hpp"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "samplers/nets/faure.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which compiles this file once for every instruction set.
#include <hwy/highway.h>

#ifndef FF_SAMPLERS_FAURE_ONCE
#define FF_SAMPLERS_FAURE_ONCE
namespace ff::samplers {

/// Points are made in runs: within one, only the lowest four digits of the index change, and with them only the first
/// four digits of a coordinate.
inline constexpr std::size_t run_length = 625;
inline constexpr std::size_t max_lanes = 16;

/// Nodes of the tree of digits: the root is 0, the children of n are 5n + 1 to 5n + 5. The levels above the first three
/// digits, `top_nodes` of them, are gone through once for the points of a block.
inline constexpr std::size_t top_digits = 3;
inline constexpr std::size_t top_cells = 125;
inline constexpr std::uint32_t top_nodes = 1 + 5 + 25;

/// More digits are drawn, not computed: 5^13 < 2^32 < 5^14.
inline constexpr std::size_t max_digits = 13;

/// The first four digits of a coordinate, one a byte, the most significant in the lowest.
constexpr std::uint32_t pack(const FaureDigits& digits) {
    return digits[0] | digits[1] << 8 | digits[2] << 16 | digits[3] << 24;
}

/// Room for reading and writing a whole vector past the end.
template <std::size_t size>
using Row = std::array<std::uint32_t, size + max_lanes>;

/// Packed digits of the points of run 0.
constexpr Row<run_length> tabulate_run(std::size_t d) {
    Row<run_length> table{};
    for (std::size_t i = 0; i < run_length; ++i) table[i] = pack(faure_digits(i, d));
    return table;
}

/// Packed digits of the cells of the first three digits, in their order in the unit interval.
constexpr Row<top_cells> tabulate_top() {
    Row<top_cells> table{};
    for (std::uint32_t i = 0; i < top_cells; ++i) table[i] = i / 25 | i / 5 % 5 << 8 | i % 5 << 16;
    return table;
}

/// A constant of its own for each coordinate: compilers limit the work on one.
template <std::size_t d>
inline constexpr Row<run_length> run_table = tabulate_run(d);
inline constexpr std::array<Row<run_length>, max_dimension> run_tables{run_table<0>, run_table<1>, run_table<2>,
                                                                       run_table<3>};
inline constexpr Row<top_cells> top_table = tabulate_top();

/// Key of the permutations of one coordinate.
struct NodeKey {
    std::uint32_t addend = 0;
    std::uint32_t mask = 0;
};

}  // namespace ff::samplers
#endif

HWY_BEFORE_NAMESPACE();
namespace ff::samplers {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Lanes32 = hn::CappedTag<std::uint32_t, max_lanes>;
using Lanes16 = hn::Repartition<std::uint16_t, Lanes32>;
using Lanes8 = hn::Repartition<std::uint8_t, Lanes32>;
using Vec32 = hn::Vec<Lanes32>;

HWY_INLINE Vec32 times_five(Vec32 x) {
    return hn::Add(hn::ShiftLeft<2>(x), x);
}

/// Products below 2^16, which cost half as much as those of 32 bits.
HWY_INLINE Vec32 multiply_small(Vec32 a, Vec32 b) {
    const Lanes16 narrow;
    return hn::BitCast(Lanes32(), hn::Mul(hn::BitCast(narrow, a), hn::BitCast(narrow, b)));
}

/// Each byte modulo 5. @pre bytes below 10: one less 5 wraps around where it must not be taken
HWY_INLINE Vec32 reduce_bytes(Vec32 x) {
    const auto bytes = hn::BitCast(Lanes8(), x);
    return hn::BitCast(Lanes32(), hn::Min(bytes, hn::Sub(bytes, hn::Set(Lanes8(), std::uint8_t{5}))));
}

/// The random word of a node: lowbias32 [wellons2018], a bijection, with one key before and one within.
HWY_INLINE Vec32 node_word(Vec32 node, const NodeKey& key) {
    const Lanes32 d;
    Vec32 x = hn::Add(node, hn::Set(d, key.addend));
    x = hn::Mul(hn::Xor(x, hn::ShiftRight<16>(x)), hn::Set(d, 0x7feb352du));
    x = hn::Xor(x, hn::Set(d, key.mask));
    x = hn::Mul(hn::Xor(x, hn::ShiftRight<15>(x)), hn::Set(d, 0x846ca68bu));
    return hn::Xor(x, hn::ShiftRight<16>(x));
}

/// (factor * digit + offset) mod 5, where the word makes a factor of 1 to 4 and an offset of 0 to 4.
HWY_INLINE Vec32 permute(Vec32 digit, Vec32 word) {
    const Lanes32 d;
    const Vec32 factor = hn::Add(hn::ShiftRight<30>(word), hn::Set(d, 1u));
    const Vec32 offset = hn::ShiftRight<29>(times_five(hn::And(word, hn::Set(d, 0x1fffffffu))));
    const Vec32 sum = hn::Add(multiply_small(factor, digit), offset);
    const Vec32 quotient = hn::ShiftRight<6>(multiply_small(sum, hn::Set(d, 13u)));  // sum / 5, exact up to 20
    return hn::Sub(sum, times_five(quotient));
}

/// Points on their way down the tree of digits.
struct Walk {
    Vec32 node;
    Vec32 value;  ///< the scrambled digits so far, as one integer
};

HWY_INLINE void descend(Walk& walk, Vec32 digit, const NodeKey& key) {
    walk.value = hn::Add(times_five(walk.value), permute(digit, node_word(walk.node, key)));
    walk.node = hn::Add(hn::Add(times_five(walk.node), digit), hn::Set(Lanes32(), 1u));
}

/// The scrambled first three digits, by the unscrambled ones.
void scramble_top(const NodeKey& key, Row<top_cells>& top) {
    const Lanes32 d;
    for (std::size_t i = 0; i < top_cells; i += hn::Lanes(d)) {
        Vec32 packed = hn::LoadU(d, &top_table[i]);
        Walk walk{hn::Zero(d), hn::Zero(d)};
        for (std::size_t j = 0; j < top_digits; ++j) {
            descend(walk, hn::And(packed, hn::Set(d, 0xffu)), key);
            packed = hn::ShiftRight<8>(packed);
        }
        hn::StoreU(walk.value, d, &top[i]);
    }
}

/// The first three of four packed digits as one integer.
HWY_INLINE Vec32 join_top(Vec32 packed) {
    const Lanes32 d;
    const Vec32 one_digit = hn::Set(d, 0xffu);
    const Vec32 first = hn::And(packed, one_digit);
    const Vec32 second = hn::And(hn::ShiftRight<8>(packed), one_digit);
    const Vec32 third = hn::And(hn::ShiftRight<16>(packed), one_digit);
    return hn::Add(times_five(hn::Add(times_five(first), second)), third);
}

/// Scrambles the first `digits` digits of `count` points within a run.
/// @param common  the digits that the other digits of the index give to every point of the run
void scramble_run(const std::uint32_t* HWY_RESTRICT table, const Row<top_cells>& top, const FaureDigits& common,
                  std::size_t digits, const NodeKey& key, std::size_t count, std::uint32_t* HWY_RESTRICT out) {
    const Lanes32 d;
    const hn::RebindToSigned<Lanes32> index;
    const Vec32 packed_common = hn::Set(d, pack(common));
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const Vec32 packed = reduce_bytes(hn::Add(hn::LoadU(d, table + i), packed_common));
        const Vec32 cell = join_top(packed);
        Walk walk{hn::Add(cell, hn::Set(d, top_nodes)), hn::GatherIndex(d, top.data(), hn::BitCast(index, cell))};
        descend(walk, hn::ShiftRight<24>(packed), key);
        for (std::size_t j = top_digits + 1; j < digits; ++j) descend(walk, hn::Set(d, common[j]), key);
        hn::StoreU(walk.value, d, out + i);
    }
}

/// (value + x / 2^32) / 5^digits in fixed point; `row` holds x, and receives the result.
void place_inside(const Row<block_capacity>& values, std::uint64_t width, std::size_t count,
                  std::uint32_t* HWY_RESTRICT row) {
    const Lanes32 d;
    const Vec32 high = hn::Set(d, static_cast<std::uint32_t>(width >> 32));
    const Vec32 low = hn::Set(d, static_cast<std::uint32_t>(width));
    const auto carry = [&](Vec32 value, Vec32 x) HWY_ATTR {  // carry of the even lanes, without value * high
        const auto inside = hn::Add(hn::MulEven(x, high), hn::ShiftRight<32>(hn::MulEven(x, low)));
        return hn::BitCast(d, hn::ShiftRight<32>(hn::Add(hn::MulEven(value, low), inside)));
    };
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const Vec32 value = hn::LoadU(d, values.data() + i);
        const Vec32 x = hn::LoadU(d, row + i);
        const Vec32 even = carry(value, x);
        const Vec32 odd = carry(hn::Shuffle2301(value), hn::Shuffle2301(x));
        const Vec32 carried = hn::OddEven(hn::Shuffle2301(odd), even);
        hn::StoreU(hn::Add(hn::Mul(value, high), carried), d, row + i);
    }
}

/// One coordinate of `count` points; `row` holds their place within the last cell.
void fill_coordinate(std::size_t coordinate, std::size_t digits, NodeKey key, PointIndex first, std::size_t count,
                     std::uint32_t* HWY_RESTRICT row) {
    Row<top_cells> top;
    scramble_top(key, top);
    Row<block_capacity> values;
    for (std::size_t done = 0; done < count;) {
        const std::size_t skipped = (first + done) % run_length;
        const std::size_t part = std::min(count - done, run_length - skipped);
        scramble_run(run_tables[coordinate].data() + skipped, top, faure_digits(first + done - skipped, coordinate),
                     digits, key, part, values.data() + done);
        done += part;
    }
    place_inside(values, reciprocal(integer_power(faure_base, digits)), count, row);
}

}  // namespace HWY_NAMESPACE
}  // namespace ff::samplers
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ff::samplers {

HWY_EXPORT(fill_coordinate);

Faure::Faure(const PointSetSpec& spec)
    : digits_(std::clamp<std::size_t>(count_digits(spec.points, faure_base), top_digits + 1, max_digits)) {}

void Faure::fill(const Stream& stream, PointIndex first, PointBlock& block) const {
    philox_block(stream, Purpose::coordinates, first, block);
    const Words addends = philox(stream, 0, Purpose::scramble);
    const Words masks = philox(stream, 1, Purpose::scramble);
    for (std::size_t d = 0; d < block.dimension; ++d) {
        HWY_DYNAMIC_DISPATCH(fill_coordinate)
        (d, digits_, {addends[d], masks[d]}, first, block.size, block.coordinate[d].data());
    }
}

}  // namespace ff::samplers
#endif
