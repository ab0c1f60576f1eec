#pragma once

#include <Eigen/Core>
#include <boost/container/small_vector.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace ff {

/// Columns of equal length, one after the other, whose rows are taken eight at a time.
template <class Number>
struct EdgeTable {
    Number* data;
    std::size_t rows;  ///< a multiple of 8

    [[nodiscard]] static std::size_t rows_for(std::size_t count) { return (count + 7) / 8 * 8; }
    [[nodiscard]] Number& operator()(int column, std::size_t row) const {
        return data[static_cast<std::size_t>(column) * rows + row];
    }
    [[nodiscard]] Number* at(int column, std::size_t row) const { return &(*this)(column, row); }
    /// The vector whose components lie in three columns.
    [[nodiscard]] Eigen::Vector3d vector(int column, std::size_t row) const {
        return {(*this)(column, row), (*this)(column + 1, row), (*this)(column + 2, row)};
    }
    void set(int column, std::size_t row, const Eigen::Vector3d& vector) const {
        for (int axis = 0; axis < 3; ++axis) (*this)(column + axis, row) = vector[axis];
    }
};

/// Columns of edges of polygons: both ends.
namespace edge_ends {
enum Column : std::uint8_t { ax, ay, az, bx, by, bz, count };
}

/// Columns of edges as seen from a place: where they begin, relative to the place; the normal of the plane through the
/// edge and the place, which leads to the inside of the polygon; the rounding of heights above that plane, of places at
/// a distance and at any distance; what is known of their position; and the side from which the polygon is seen: 1 for
/// its front, -1 for its back, 0 where it does not count.
namespace seen_edge {
enum Column : std::uint8_t { ax, ay, az, nx, ny, nz, by_distance, fixed, position, side, count };
}

/// Bits of a position: the target reaches to the inside of the edge, or to its outside; from the third on, one for each
/// of the target's edges that this one begins beyond.
inline constexpr int reaches_inside = 1;
inline constexpr int reaches_outside = 2;
inline constexpr int first_beyond = 4;

/// A corner of the target, relative to the place, or the normal of the plane through an edge of it and the place.
struct TargetVector {
    Eigen::Vector3d vector;
    double length = 0;  ///< sum of the sizes of its components
};
using TargetVectors = boost::container::small_vector<TargetVector, 6>;

/// Sees edges from a place, but for those of polygons that do not count.
/// @param rounding  of coordinates
/// @param result    with the sides
void see_edges(EdgeTable<const double> edges, const Eigen::Vector3d& place, double rounding,
               const TargetVectors& target_corners, const TargetVectors& target_sides, EdgeTable<double> result);

/// An edge as seen from a place, as above.
struct SeenEdge {
    Eigen::Vector3d normal;
    Eigen::Vector3d a;
    Eigen::Vector3d b;
    double by_distance = 0;
    double fixed = 0;
};

/// Columns of edges that may be part of an outline, as above, with the rank of their polygon.
namespace outline_edge {
enum Column : std::uint8_t { ax, ay, az, bx, by, bz, nx, ny, nz, by_distance, fixed, rank, count };
}

/// Finds which part of each edge is inside of each polygon. Where an edge lies on one of the polygon's, it is inside if
/// both polygons are on the same side of it and this one has the lower rank.
/// @param cuts    edges of each polygon, by rank; places that count are inside of all others
/// @param ends    index of the last of them for each polygon, plus one
/// @param result  two columns for each polygon: shares of the edge's length between which it is inside
void cover_edges(EdgeTable<const double> edges, std::span<const SeenEdge> cuts, std::span<const std::uint32_t> ends,
                 EdgeTable<double> result);

}  // namespace ff
