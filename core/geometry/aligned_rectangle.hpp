#pragma once

#include "core/geometry/scene.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace ff {

/// From `low` to `high` along one axis. Extended precision keeps sums of a corner and an edge exact far from the
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

}  // namespace ff
