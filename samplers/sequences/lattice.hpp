#pragma once

#include "samplers/sampler.hpp"
#include "samplers/support/owen_hash.hpp"

#include <array>

namespace ff::samplers {

/// An extensible rank-1 lattice with a random shift. @see [cools2006], [hickernell2000], [cranley1976], [sloan2002]
class Lattice {
  public:
    static constexpr SamplerInfo info{
        .name = "lattice",
        .summary = "rank-1 lattice with a random shift",
        .details =
            "Point i is the fraction of r(i) z + s: r(i) is the radical inverse of i in base 2, z = (1, 6906571, "
            "12751639, 4408903) the generating vector, s a uniform shift (Philox). The first 2^m points are the "
            "lattice of all multiples of z / 2^m, for every m at once (Hickernell and others 2000).\n"
            "The vector was found here, component by component: up to 2^12 the one whose worst ratio to the best "
            "lattice of each size is least (Cools, Kuo and Nuyens 2006), then one binary digit more for each doubling, "
            "up to 2^24; a unit test finds it again. The criterion is the worst-case error, root mean square over "
            "shifts, in the unanchored Sobolev space of mixed first derivatives with weights 1: 1.3e-2 at 2^8 points, "
            "1.2e-3 at 2^12, 1.5e-4 at 2^16, 1.2e-5 at 2^20, 1.4e-6 at 2^24, where random points have 5.8e-2, 1.4e-2, "
            "3.6e-3, 9.0e-4, 2.3e-4.\n"
            "Sizes: powers of two; with others the set is not a lattice, estimates stay unbiased and lose part of "
            "their gain. Beyond 2^24 points the vector is not adapted. The error falls as N^-1 for smooth integrands, "
            "faster for periodic ones. The shift is all that is random. Points of one set are not independent: take "
            "intervals over trials, never within a set.",
        .reference = "cools2006",
        .sizes = Sizes::powers,
        .spread = Spread::lattice,
    };

    static constexpr std::array<std::uint32_t, max_dimension> generating_vector{1, 6906571, 12751639, 4408903};

    explicit Lattice(const PointSetSpec& /*spec*/) {}

    void fill(const Stream& stream, PointIndex first, PointBlock& block) const {
        const Words shift = philox(stream, 0, Purpose::scramble);
        for (std::size_t i = 0; i < block.size; ++i) {
            const std::uint32_t radical_inverse = reverse_bits(static_cast<std::uint32_t>(first + i));
            for (std::size_t d = 0; d < block.dimension; ++d) {
                block.coordinate[d][i] = radical_inverse * generating_vector[d] + shift[d];
            }
        }
    }
};

}  // namespace ff::samplers
