#pragma once

#include "core/geometry/convex_polygon.hpp"

#include <Eigen/Core>
#include <boost/container/small_vector.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <utility>

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

/// Adds up Lambert's formula for pieces of what is seen from several places, many edges at a time.
class ArcSums {
  public:
    ArcSums(Eigen::Vector3d normal, std::size_t places) : normal_(std::move(normal)), sums_(places, 0.0) {}

    /// @param piece  corners, in order
    /// @param sign  of its factor in the sum of a place
    template <class Polygon>
    void add(std::size_t place, const Polygon& piece, double sign) {
        for (std::size_t k = 0; k < piece.size(); ++k) {
            if (arcs_.is_full()) flush();
            of_[arcs_.size] = {static_cast<std::uint32_t>(place), sign};
            arcs_.add(piece[k], next_corner(piece, k));
        }
    }

    /// By place.
    [[nodiscard]] std::span<const double> result() {
        flush();
        return {sums_.data(), sums_.size()};
    }

  private:
    struct Owner {
        std::uint32_t place;
        double sign;
    };
    Eigen::Vector3d normal_;
    boost::container::small_vector<double, 64> sums_;
    Arcs arcs_;
    std::array<Owner, Arcs::capacity> of_;

    void flush() {
        std::array<double, Arcs::capacity> terms;
        find_arc_terms(arcs_, normal_, terms);
        for (std::size_t k = 0; k < arcs_.size; ++k)
            sums_[of_[k].place] += of_[k].sign * terms[k] * (0.5 / std::numbers::pi);
        arcs_.size = 0;
    }
};

}  // namespace ff
