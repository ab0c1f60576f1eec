#include "samplers/grids/latin_hypercube.hpp"

#include "samplers/support/philox_block.hpp"
#include "samplers/support/sizes.hpp"

#include <bit>
#include <numeric>
#include <utility>

namespace ff::samplers {
namespace {

/// Rows 0 to d of `order` become random permutations of 0 .. points - 1. @pre 2 <= points <= block_capacity
void shuffle(const Stream& stream, std::uint64_t points, PointBlock& order) {
    PointBlock words;
    words.dimension = order.dimension;
    words.size = points;
    philox_block(stream, Purpose::permutation, 0, words);
    for (std::size_t d = 0; d < order.dimension; ++d) {
        auto& row = order.coordinate[d];
        std::iota(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(points), 0u);
        for (std::uint64_t left = points; left > 1; --left) {
            const std::uint64_t picked = words.coordinate[d][left - 1] * left >> 32;
            std::swap(row[left - 1], row[picked]);
        }
    }
}

/// A keyed bijection of 0 .. points - 1. With four rounds it is a good permutation of a hundred numbers and more.
class Permutation {
  public:
    Permutation(const Stream& stream, std::size_t d, std::uint64_t points)
        : last_(static_cast<std::uint32_t>(points - 1)),
          mask_(~std::uint32_t{0} >> std::countl_zero(last_)),
          shift_((static_cast<std::uint32_t>(std::bit_width(last_)) + 1) / 2) {
        for (std::uint32_t round = 0; round < rounds; ++round) {
            multipliers_[round] = philox(stream, 2 * round, Purpose::scramble)[d] | 1u;
            addends_[round] = philox(stream, 2 * round + 1, Purpose::scramble)[d];
        }
    }

    std::uint32_t operator()(std::uint32_t x) const {
        do {
            for (std::size_t round = 0; round < rounds; ++round) {
                x = (x * multipliers_[round] + addends_[round]) & mask_;
                x ^= x >> shift_;
            }
        } while (x > last_);
        return x;
    }

  private:
    static constexpr std::size_t rounds = 4;

    std::uint32_t last_;
    std::uint32_t mask_;  ///< least 2^k - 1 that is not below `last_`
    std::uint32_t shift_;
    std::array<std::uint32_t, rounds> multipliers_{};
    std::array<std::uint32_t, rounds> addends_{};
};

}  // namespace

void LatinHypercube::fill(const Stream& stream, PointIndex first, PointBlock& block) const {
    philox_block(stream, Purpose::coordinates, first, block);
    if (points_ == 1) return;
    const std::uint64_t width = reciprocal(points_);
    const auto place = [&](std::size_t d, auto slice_of) {
        for (std::size_t i = 0; i < block.size; ++i) {
            std::uint32_t& x = block.coordinate[d][i];
            x = place_in_cell(slice_of(first + i), width, x);
        }
    };
    if (points_ <= block_capacity) {
        PointBlock order;
        order.dimension = block.dimension;
        shuffle(stream, points_, order);
        for (std::size_t d = 0; d < block.dimension; ++d) {
            place(d, [&](PointIndex i) { return order.coordinate[d][i]; });
        }
    } else {
        for (std::size_t d = 0; d < block.dimension; ++d) {
            const Permutation permutation(stream, d, points_);
            place(d, [&](PointIndex i) { return permutation(static_cast<std::uint32_t>(i)); });
        }
    }
}

}  // namespace ff::samplers
