#pragma once

#include "core/geometry/fwd.hpp"

#include <cstdint>

namespace ff {

/// Parts of equal area that a surface is divided into. Part row*columns + column lies at s in [column/columns,
/// (column+1)/columns] and t in [row/rows, (row+1)/rows]: on a parallelogram, along edge_u and edge_v. Both are 1 or
/// more.
struct Grid {
    std::uint32_t columns;
    std::uint32_t rows;

    [[nodiscard]] std::uint32_t parts() const { return columns * rows; }
    bool operator==(const Grid&) const = default;
};

/// A surface that is not divided.
inline constexpr Grid undivided{1, 1};

/// m x m patches in every part of a surface's grid. The patches of a scene are numbered surface by surface, on each as
/// the parts of their grid are: core/patches/patch_order.hpp.
struct Subdivision {
    std::uint32_t m = 1;

    [[nodiscard]] std::uint32_t per_part() const { return m * m; }
    /// The patches of a surface.
    [[nodiscard]] Grid of(const Surface& surface) const;
    /// The patches of a scene.
    [[nodiscard]] std::uint64_t patches(const Scene& scene) const;
};

}  // namespace ff
