#pragma once

#include "core/geometry/fwd.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace ff {

/// An interval along one axis. Extended precision keeps sums of a corner and an edge exact far from the
/// origin.
struct AxisInterval {
    long double low = 0;
    long double high = 0;
};

/// A rectangle with edges along the axes: an interval along each of them, of length 0 along `axis`, its normal.
struct AlignedRectangle {
    std::array<AxisInterval, 3> extent;
    std::size_t axis = 2;
    int side = 1;  ///< the normal points to +axis (1) or to -axis (-1)

    [[nodiscard]] long double plane() const { return extent[axis].low; }
};

/// Empty unless both edges and the normal are exactly along different axes.
std::optional<AlignedRectangle> aligned_rectangle(const Surface& surface);

/// The elementary formulas behind core/exact/exact.hpp: exchange areas A_1 F_12, in squared units of length, as sums of
/// an antiderivative of the kernel over all pairs of corners. `Real` is the precision of the computation, double or
/// long double; the error is about 2 ulp of the squared extent of the pair, never relative to the result.

/// Two rectangles in parallel planes `gap` apart that face each other; any offset and overlap.
/// @pre gap > 0   @see [howell] C-13, [ehlert1993]
template <class Real>
Real parallel_exchange_area(const AxisInterval& x_from, const AxisInterval& y_from, const AxisInterval& x_to,
                            const AxisInterval& y_to, long double gap);

/// One corner term of `parallel_exchange_area`, times 2 pi: the kernel 1 / (pi r^4), integrated four times, at offsets
/// u, v >= 0 in the two directions of the planes, `gap` apart.
template <class Real>
Real parallel_corner(Real u, Real v, Real gap);

/// Two rectangles in perpendicular planes, each wholly in front of the other: `along` is the axis parallel to both
/// planes, `height` the distance of a rectangle's points from the other one's plane (its low end is 0 where the
/// rectangle touches that plane).
/// @pre all heights >= 0   @see [howell] C-15, [ehlert1993]
template <class Real>
Real perpendicular_exchange_area(const AxisInterval& along_from, const AxisInterval& along_to,
                                 const AxisInterval& height_from, const AxisInterval& height_to);

}  // namespace ff
