#include "samplers/nets/sobol.hpp"

#include "samplers/nets/sobol_directions.hpp"
#include "samplers/support/owen_hash.hpp"

#include <algorithm>
#include <array>
#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "samplers/nets/sobol.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which compiles this file once for every instruction set.
#include <hwy/highway.h>

#include "samplers/support/owen_hash-inl.h"

#ifndef FF_SAMPLERS_SOBOL_ONCE
#define FF_SAMPLERS_SOBOL_ONCE
namespace ff::samplers {

/// Points are made in aligned groups: within one, only the lowest four bits of the index change.
inline constexpr std::uint32_t group_bits = 4;
inline constexpr std::uint32_t group_size = 1u << group_bits;

/// One coordinate of the sequence with the bits reversed, as the hash needs them.
struct ReversedSobol {
    std::array<std::uint32_t, 32> direction{};
    alignas(64) std::array<std::uint32_t, group_size> low{};  ///< coordinate of the points of group 0
    std::array<std::uint32_t, 32> step{};  ///< what changes from group g to g + 1, by the number of trailing ones of g

    /// The part that the points of a group have in common.
    [[nodiscard]] std::uint32_t base(std::uint32_t group) const {
        std::uint32_t x = 0;
        for (; group != 0; group &= group - 1)
            x ^= direction[group_bits + static_cast<std::uint32_t>(std::countr_zero(group))];
        return x;
    }
};

constexpr ReversedSobol reverse(const std::array<std::uint32_t, 32>& directions) {
    ReversedSobol result;
    for (std::size_t j = 0; j < 32; ++j) result.direction[j] = reverse_bits(directions[j]);
    for (std::uint32_t i = 0; i < group_size; ++i) {
        for (std::size_t j = 0; j < group_bits; ++j) {
            if ((i >> j & 1u) != 0) result.low[i] ^= result.direction[j];
        }
    }
    std::uint32_t step = 0;
    for (std::size_t j = group_bits; j < 32; ++j) result.step[j - group_bits] = step ^= result.direction[j];
    return result;
}

inline constexpr std::array<ReversedSobol, max_dimension> reversed_sobol{
    reverse(sobol_directions[0]), reverse(sobol_directions[1]), reverse(sobol_directions[2]),
    reverse(sobol_directions[3])};

}  // namespace ff::samplers
#endif

HWY_BEFORE_NAMESPACE();
namespace ff::samplers {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE void fill_group(const ReversedSobol& sobol, std::uint32_t base, OwenSeed seed,
                           std::uint32_t* HWY_RESTRICT out) {
    const Lanes32 d;
    for (std::size_t i = 0; i < group_size; i += hn::Lanes(d)) {
        const Vec32 x = hn::Xor(hn::Set(d, base), hn::Load(d, &sobol.low[i]));
        hn::StoreU(reverse_bits_of(owen_hash_of(x, seed)), d, out + i);
    }
}

/// `count` values of one coordinate from point `first` on. `row` has room for block_capacity.
void fill_coordinate(const ReversedSobol& sobol, OwenSeed seed, PointIndex first, std::size_t count,
                     std::uint32_t* HWY_RESTRICT row) {
    auto group = static_cast<std::uint32_t>(first >> group_bits);
    std::uint32_t base = sobol.base(group);
    const auto next_group = [&] { base ^= sobol.step[static_cast<std::size_t>(std::countr_one(group++))]; };
    alignas(64) std::array<std::uint32_t, group_size> part;

    std::size_t done = 0;
    if (const std::size_t skipped = first % group_size; skipped != 0) {
        fill_group(sobol, base, seed, part.data());
        done = std::min<std::size_t>(count, group_size - skipped);
        std::copy_n(part.data() + skipped, done, row);
        next_group();
    }
    for (; done < count && done + group_size <= block_capacity; done += group_size) {
        fill_group(sobol, base, seed, row + done);
        next_group();
    }
    if (done < count) {
        fill_group(sobol, base, seed, part.data());
        std::copy_n(part.data(), count - done, row + done);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace ff::samplers
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ff::samplers {

HWY_EXPORT(fill_coordinate);

void Sobol::fill(const Stream& stream, PointIndex first, PointBlock& block) const {
    const Words addends = philox(stream, 0, Purpose::scramble);
    const Words multipliers = philox(stream, 1, Purpose::scramble);
    for (std::size_t d = 0; d < block.dimension; ++d) {
        const OwenSeed seed{addends[d], multipliers[d]};
        HWY_DYNAMIC_DISPATCH(fill_coordinate)(reversed_sobol[d], seed, first, block.size, block.coordinate[d].data());
    }
}

}  // namespace ff::samplers
#endif
