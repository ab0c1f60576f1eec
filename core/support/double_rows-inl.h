// Sums of doubles that are the same to the bit on every CPU: included once for each instruction set by the files that
// need it.

#if defined(FF_CORE_DOUBLE_ROWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FF_CORE_DOUBLE_ROWS_INL_H_
#undef FF_CORE_DOUBLE_ROWS_INL_H_
#else
#define FF_CORE_DOUBLE_ROWS_INL_H_
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace ff {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using DoubleTag = hn::CappedTag<double, 8>;
using Doubles = hn::Vec<DoubleTag>;

/// Points are taken in rows of eight; a row is one vector, or two, or four.
constexpr std::size_t row = 8;
constexpr std::size_t lanes = hn::MaxLanes(DoubleTag());
constexpr std::size_t vectors = row / lanes;

HWY_INLINE Doubles constant(double value) {
    return hn::Set(DoubleTag(), value);
}

/// Eight sums, one for each place in a row, whatever the vector length.
class Columns {
  public:
    HWY_INLINE Columns() {
        for (Doubles& sum : sums_) sum = hn::Zero(DoubleTag());
    }

    /// Adds the k-th vector of a row.
    HWY_INLINE void add(std::size_t k, Doubles values) { sums_[k] = hn::Add(sums_[k], values); }

    [[nodiscard]] HWY_INLINE double total() const {
        alignas(64) std::array<double, row> sum{};
        for (std::size_t k = 0; k < vectors; ++k) hn::Store(sums_[k], DoubleTag(), &sum[k * lanes]);
        return ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
    }

  private:
    Doubles sums_[vectors];  // NOLINT(modernize-avoid-c-arrays): as a template argument it loses its alignment
};

}  // namespace HWY_NAMESPACE
}  // namespace ff
HWY_AFTER_NAMESPACE();

#endif  // FF_CORE_DOUBLE_ROWS_INL_H_
