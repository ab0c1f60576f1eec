#include "samplers/point_sets/point_set.hpp"

#include "core/support/contract.hpp"
#include "samplers/support/owen_hash.hpp"

#include <algorithm>

namespace ff::samplers {
namespace {

/// Sums of columns by byte, so that a product takes four look-ups.
using ByteTables = std::array<std::array<std::uint32_t, 256>, 4>;

ByteTables draw_matrix(const Stream& stream, std::size_t d) {
    ByteTables sums{};
    for (std::uint32_t bit = 0; bit < 32; ++bit) {
        const std::uint32_t diagonal = 1u << bit;
        const std::uint32_t word = philox(stream, 31 - bit, Purpose::scramble)[d];
        const std::uint32_t column = diagonal | (word & (diagonal - 1));
        auto& table = sums[bit / 8];
        const std::uint32_t half = 1u << bit % 8;
        for (std::uint32_t low = 0; low < half; ++low) table[half + low] = table[low] ^ column;
    }
    return sums;
}

std::uint32_t multiply_by_bytes(const ByteTables& sums, std::uint32_t x) {
    return sums[0][x & 255u] ^ sums[1][x >> 8 & 255u] ^ sums[2][x >> 16 & 255u] ^ sums[3][x >> 24];
}

class SetPoints final : public PointSource {
  public:
    SetPoints(std::shared_ptr<const PointSet> set, std::uint64_t points, Randomisation how)
        : set_(std::move(set)), points_(points), how_(how) {}

    [[nodiscard]] std::uint64_t points() const override { return points_; }
    [[nodiscard]] bool randomised() const override { return how_ != Randomisation::none || set_->sets > 1; }
    [[nodiscard]] bool equal_weights() const override { return true; }

    using PointSource::fill;
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const override {
        FF_EXPECT(block.dimension <= set_->dimension && first + block.size <= points_);
        const std::uint64_t set = stream.trial % set_->sets;
        for (std::size_t d = 0; d < block.dimension; ++d) {
            const auto from = set_->row(set, d).subspan(first, block.size);
            std::copy(from.begin(), from.end(), block.coordinate[d].begin());
            randomise(how_, stream, d, std::span(block.coordinate[d]).first(block.size));
        }
    }

  private:
    std::shared_ptr<const PointSet> set_;
    std::uint64_t points_;
    Randomisation how_;
};

}  // namespace

std::optional<Randomisation> find_randomisation(std::string_view name) {
    const auto* const found = std::find(randomisation_names.begin(), randomisation_names.end(), name);
    if (found == randomisation_names.end()) return std::nullopt;
    return static_cast<Randomisation>(found - randomisation_names.begin());
}

void randomise(Randomisation how, const Stream& stream, std::size_t d, std::span<std::uint32_t> row) {
    const auto word = [&](std::uint32_t index) { return philox(stream, index, Purpose::scramble)[d]; };
    switch (how) {
        case Randomisation::none:
            return;
        case Randomisation::shift: {
            const std::uint32_t shift = word(32);
            for (std::uint32_t& x : row) x += shift;
            return;
        }
        case Randomisation::digital_shift: {
            const std::uint32_t shift = word(32);
            for (std::uint32_t& x : row) x ^= shift;
            return;
        }
        case Randomisation::lms: {
            const ByteTables matrix = draw_matrix(stream, d);
            const std::uint32_t shift = word(32);
            for (std::uint32_t& x : row) x = multiply_by_bytes(matrix, x) ^ shift;
            return;
        }
        case Randomisation::owen: {
            const OwenSeed seed{word(0), word(1)};
            for (std::uint32_t& x : row) x = owen_scramble(x, seed);
            return;
        }
    }
}

std::unique_ptr<PointSource> points_of_set(std::shared_ptr<const PointSet> set, std::uint64_t points,
                                           Randomisation how) {
    FF_EXPECT(points <= set->points);
    return std::make_unique<SetPoints>(std::move(set), points, how);
}

}  // namespace ff::samplers
