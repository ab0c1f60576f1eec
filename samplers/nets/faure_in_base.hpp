#pragma once

#include "samplers/sampler.hpp"

namespace ff::samplers {

/// The Faure sequence in a larger prime base than `faure`, nested-scrambled in the same way. One line of the catalogue
/// for each base: 7, 11 and 13. @see [faure1982], [owen1995]
template <std::uint32_t prime>
class FaureInBase {
    static_assert(prime == 7 || prime == 11 || prime == 13);

  public:
    static constexpr SamplerInfo info{
        .name = prime == 7    ? "faure_7"
                : prime == 11 ? "faure_11"
                              : "faure_13",
        .summary = prime == 7    ? "Faure points in base 7 with nested scrambling: a (0, 4)-sequence"
                   : prime == 11 ? "Faure points in base 11 with nested scrambling: a (0, 4)-sequence"
                                 : "Faure points in base 13 with nested scrambling: a (0, 4)-sequence",
        .details =
            "`faure` in another prime base b. Any prime that is not below the dimension makes a (0, d)-sequence: any "
            "b^m points that start at a multiple of b^m have one point in each elementary interval of volume b^-m. The "
            "smallest such base is the best (5 in four dimensions); a larger one is for its sizes: 49, 343, 2401, ... "
            "in base 7, 121, 1331, 14641, ... in base 11, 169, 2197, 28561, ... in base 13. Each node of the tree of "
            "digits permutes them by a random affine map; digits beyond the last are drawn.\n"
            "With other sizes estimates stay unbiased and lose part of their gain. Slower than `faure`, some ten "
            "nanoseconds for each digit of a point. Points of one set are not independent: take intervals over trials, "
            "never within a set.",
        .reference = "faure1982",
        .sizes = Sizes::powers,
        .base = prime,
        .nanoseconds = 100,
    };

    explicit FaureInBase(const PointSetSpec& spec);
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const;

  private:
    std::size_t digits_;  ///< scrambled digits: enough to keep the points of the set distinct
};

extern template class FaureInBase<7>;
extern template class FaureInBase<11>;
extern template class FaureInBase<13>;

}  // namespace ff::samplers
