#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <span>

namespace ff {

/// Edges of polygons as seen from places on a plane, for Lambert's formula: from one corner to another, both relative
/// to the place.
struct Arcs {
    static constexpr std::size_t capacity = 256;  ///< a multiple of 8

    using Component = std::array<double, capacity>;
    alignas(64) Component ax, ay, az, bx, by, bz;
    std::size_t size = 0;

    [[nodiscard]] bool is_full() const { return size == capacity; }
    void add(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
        ax[size] = a.x();
        ay[size] = a.y();
        az[size] = a.z();
        bx[size] = b.x();
        by[size] = b.y();
        bz[size] = b.z();
        ++size;
    }
};

/// For each arc, the angle under which it is seen times the cosine between the normal of the plane and that of the
/// triangle from the place to the arc, a x b; 0 where the arc has no length. The same bits on every CPU. Divided by
/// 2 pi, the terms around a polygon add up to its form factor.
/// @param arcs   padded by this function
/// @param terms  at least Arcs::capacity
void find_arc_terms(Arcs& arcs, const Eigen::Vector3d& normal, std::span<double> terms);

}  // namespace ff
