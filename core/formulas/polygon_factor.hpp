#pragma once

#include "core/geometry/convex_polygon.hpp"
#include "core/points/points.hpp"

#include <Eigen/Core>
#include <boost/container/small_vector.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace ff {

/// The exact form factor from a differential area to a polygon (Lambert's formula): each edge contributes the angle
/// under which it is seen times the cosine between the normal and the plane through the edge and the point.
/// The differential area lies in the plane z = 0 and radiates upwards. @see [baum1989]

/// Vertices in order, counter-clockwise as seen from the side that receives.
using Polygon = std::vector<Eigen::Vector3d>;

/// The part of a convex polygon on or above the plane z = 0; fewer than three vertices where there is none.
Polygon clip_at_horizon(const Polygon& polygon);

/// Weighted points (x, y, 0). Padded with weights of 0 to a multiple of eight.
struct PlanePoints {
    using Component = std::array<double, block_capacity>;
    alignas(64) Component x, y, weight;
    std::size_t size = 0;  ///< multiple of 8
};

/// The sum over points of weight * form factor, dimensionless. A point behind the polygon sees nothing of it; for a
/// point on an edge the limit from the receiving side is taken. Within about 1e-16 per unit of weight, times the
/// polygon's extent over the point's distance from its edges. Terms are added in eight columns whatever the vector
/// length, so every CPU gives the same bits.
/// @pre no vertex lies below the plane
double sum_polygon_factors(const PlanePoints& points, const Polygon& polygon);

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

/// Finds the term of each arc: the angle under which it is seen, times the cosine between the normals of the plane and
/// of the triangle from the place to the arc, a x b; 0 where the arc has no length. The same bits on every CPU. Divided
/// by 2 pi, the terms around a polygon add up to its form factor.
/// @param arcs   padded by this function
/// @param terms  at least Arcs::capacity
void find_arc_terms(Arcs& arcs, const Eigen::Vector3d& normal, std::span<double> terms);

/// Adds up Lambert's formula for pieces of what is seen from several places, many edges at a time.
class ArcSums {
  public:
    ArcSums(Eigen::Vector3d normal, std::size_t places) : normal_(std::move(normal)), sums_(places, 0.0) {}

    /// @param piece  corners, in order
    /// @param sign  of its factor in the sum of a place
    template <class AnyPolygon>
    void add(std::size_t place, const AnyPolygon& piece, double sign) {
        for (std::size_t k = 0; k < piece.size(); ++k) add(place, piece[k], next_corner(piece, k), sign);
    }
    /// Adds the edge from `a` to `b`.
    void add(std::size_t place, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double sign) {
        if (arcs_.is_full()) flush();
        of_[arcs_.size] = {static_cast<std::uint32_t>(place), sign};
        arcs_.add(a, b);
    }

    /// The sum of each place.
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
