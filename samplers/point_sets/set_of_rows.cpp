#include "samplers/point_sets/set_of_rows.hpp"

#include "core/support/contract.hpp"
#include "core/support/error.hpp"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "samplers/point_sets/set_of_rows.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which compiles this file once for every instruction set.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ff::samplers {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Upper half of the double 2^52 + floor(x * 2^32) for every x in [0, 1), and for no other x. The lower half is then
/// the coordinate.
constexpr std::uint64_t upper_half = 0x4330000000000000u;

/// Points from `first` on while whole vectors of them are left. @return the point after them
template <class Tag>
HWY_INLINE std::uint64_t fix_points(Tag d, const double* HWY_RESTRICT rows, std::uint64_t first, std::uint64_t points,
                                    std::size_t dimension, std::uint32_t* HWY_RESTRICT to, bool& sound) {
    const hn::RebindToUnsigned<Tag> bits;
    const hn::Rebind<std::uint32_t, Tag> half;
    auto seen = hn::Zero(bits);
    const auto fix = [&](hn::Vec<Tag> x, std::uint32_t* row) HWY_ATTR {
        const auto sum = hn::Add(hn::Floor(hn::Mul(x, hn::Set(d, 0x1p32))), hn::Set(d, 0x1p52));
        seen = hn::Or(seen, hn::Xor(hn::BitCast(bits, sum), hn::Set(bits, upper_half)));
        hn::StoreU(hn::TruncateTo(half, hn::BitCast(bits, sum)), half, row);
    };
    std::uint64_t i = first;
    for (; i + hn::Lanes(d) <= points; i += hn::Lanes(d)) {
        const double* const from = rows + i * dimension;
        hn::Vec<Tag> x0;
        hn::Vec<Tag> x1;
        hn::Vec<Tag> x2;
        hn::Vec<Tag> x3;
        switch (dimension) {
            case 4:
                hn::LoadInterleaved4(d, from, x0, x1, x2, x3);
                fix(x3, to + 3 * points + i);
                break;
            case 3:
                hn::LoadInterleaved3(d, from, x0, x1, x2);
                break;
            case 2:
                hn::LoadInterleaved2(d, from, x0, x1);
                break;
            default:
                x0 = hn::LoadU(d, from);
        }
        fix(x0, to + i);
        if (dimension > 1) fix(x1, to + points + i);
        if (dimension > 2) fix(x2, to + 2 * points + i);
    }
    sound &= hn::AllTrue(bits, hn::Eq(hn::ShiftRight<32>(seen), hn::Zero(bits)));
    return i;
}

/// @return whether all numbers are in [0, 1)
bool fix_rows(const double* rows, std::uint64_t points, std::size_t dimension, std::uint32_t* to) {
    bool sound = true;
    const std::uint64_t rest = fix_points(hn::ScalableTag<double>(), rows, 0, points, dimension, to, sound);
    fix_points(hn::CappedTag<double, 1>(), rows, rest, points, dimension, to, sound);
    return sound;
}

}  // namespace HWY_NAMESPACE
}  // namespace ff::samplers
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ff::samplers {

HWY_EXPORT(fix_rows);

void set_of_rows(std::span<const double> rows, std::uint64_t points, std::size_t dimension, const std::string& origin,
                 PointSet& set) {
    FF_EXPECT(rows.size() == points * dimension && dimension >= 1 && dimension <= max_dimension);
    set.points = points;
    set.dimension = dimension;
    set.sets = 1;
    set.coordinate.resize(rows.size());
    if (HWY_DYNAMIC_DISPATCH(fix_rows)(rows.data(), points, dimension, set.coordinate.data())) return;
    const auto bad = std::find_if(rows.begin(), rows.end(), [](double x) { return !(x >= 0 && x < 1); });
    const auto index = static_cast<std::uint64_t>(bad - rows.begin());
    throw UserError("{}: point {}, coordinate {} is {} (counted from 0; not in [0, 1)). {}", origin, index / dimension,
                    index % dimension, *bad, *bad == 1 ? "Leave out the upper end." : "Check what makes the points.");
}

}  // namespace ff::samplers
#endif
