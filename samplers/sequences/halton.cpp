#include "samplers/sequences/halton.hpp"

#include "samplers/support/sizes.hpp"

#include <algorithm>
#include <utility>

namespace ff::samplers {
namespace {

constexpr std::array<std::uint32_t, max_dimension> bases{2, 3, 5, 7};
constexpr std::uint32_t max_base = 7;
constexpr std::uint32_t max_index_digits = 32;  // digits of a 32-bit index in base 2

/// The contribution of each permuted digit to the coordinate times 2^64.
using DigitValues = std::array<std::uint64_t, max_base>;

/// A uniformly random permutation of the digits (to 2e-6 of each one's probability) from one word, scaled.
DigitValues permute_digits(std::uint32_t word, std::uint32_t base, std::uint64_t scale) {
    DigitValues values{};
    for (std::uint32_t digit = 0; digit < base; ++digit) values[digit] = digit * scale;
    std::uint64_t fraction = word;
    for (std::uint32_t digit = 0; digit + 1 < base; ++digit) {
        fraction = (fraction & 0xffffffffu) * (base - digit);
        std::swap(values[digit], values[digit + (fraction >> 32)]);
    }
    return values;
}

/// The scrambled radical inverse of successive indices in one base.
class RadicalInverse {
  public:
    RadicalInverse(const Stream& stream, std::size_t d, std::uint32_t digits, PointIndex first)
        : base_(bases[d]), digits_(digits) {
        std::uint64_t scale = reciprocal(base_);
        Words words{};
        for (std::uint32_t j = 0; j < digits; ++j) {
            if (j % 4 == 0) words = philox(stream, block_index(d, j / 4), Purpose::permutation);
            if (j > 0) scale /= base_;
            values_[j] = permute_digits(words[j % 4], base_, scale);
            digit_[j] = static_cast<std::uint32_t>(first % base_);
            first /= base_;
        }
        sum_from_[digits] = (scale >> 32) * philox(stream, block_index(d, tail_block), Purpose::permutation)[0];
        sum_down_from(digits - 1);
    }

    /// Writes coordinates of the next `count` points.
    void fill(std::uint32_t* out, std::size_t count) {
        std::uint32_t digit = digit_[0];
        for (std::size_t i = 0; i < count; ++i) {
            out[i] = static_cast<std::uint32_t>((sum_from_[1] + values_[0][digit]) >> 32);
            if (++digit == base_) {
                digit = 0;
                carry();
            }
        }
        digit_[0] = digit;
    }

  private:
    static constexpr std::uint32_t tail_block = max_index_digits / 4;

    static std::uint32_t block_index(std::size_t d, std::uint32_t block) {
        return static_cast<std::uint32_t>(d) * 16 + block;
    }

    /// The lowest digit has run over.
    void carry() {
        std::uint32_t j = 1;
        for (; j < digits_; ++j) {
            if (++digit_[j] != base_) break;
            digit_[j] = 0;
        }
        if (digits_ > 1) sum_down_from(std::min(j, digits_ - 1));
    }

    void sum_down_from(std::uint32_t highest) {
        for (std::uint32_t j = highest; j > 0; --j) sum_from_[j] = sum_from_[j + 1] + values_[j][digit_[j]];
    }

    std::uint32_t base_;
    std::uint32_t digits_;
    std::array<DigitValues, max_index_digits> values_;
    std::array<std::uint32_t, max_index_digits> digit_{};
    /// [j]: the contribution of digits j and higher to the coordinate, including the endless zeros, in units of 2^-64.
    std::array<std::uint64_t, max_index_digits + 1> sum_from_{};
};

}  // namespace

Halton::Halton(const PointSetSpec& spec) {
    for (std::size_t d = 0; d < max_dimension; ++d) digits_[d] = count_digits(spec.points, bases[d]);
}

void Halton::fill(const Stream& stream, PointIndex first, PointBlock& block) const {
    for (std::size_t d = 0; d < block.dimension; ++d) {
        RadicalInverse(stream, d, digits_[d], first).fill(block.coordinate[d].data(), block.size);
    }
}

}  // namespace ff::samplers
