#pragma once

#include "core/geometry/convex_polygon.hpp"
#include "core/visibility/edge_rows.hpp"

#include <Eigen/Core>
#include <boost/container/small_vector.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ff {

/// Outlines what the shadows of convex polygons leave of another one, as seen from a place. The outline consists of
/// parts of edges: those of the polygon that no shadow covers, and those of each shadow that lie in the polygon and
/// that no other shadow covers. No piece is cut out, so that the time hardly depends on how many shadows overlap.
///
/// Where two edges are one, up to rounding, they count once where their polygons lie on the same side of them, and not
/// at all where they lie on opposite sides. A wrong decision leaves the outline open, which is noticed; only where all
/// edges of two shadows are one could it stay closed.
class ShadowEdges {
  public:
    /// @param polygons  counter-clockwise as seen from the front; empty where there is none
    /// @param rounding  possible error of coordinates
    ShadowEdges(std::span<const ConvexPolygon> polygons, double rounding);

    /// From which side a polygon is seen; its shadow does not count where that is 0.
    using Side = std::int8_t;
    static constexpr Side front = 1;
    static constexpr Side back = -1;

    /// The side of a polygon that is seen from a place; 0 if it is seen edge-on, or nearly.
    [[nodiscard]] Side side(std::size_t polygon, const Eigen::Vector3d& place) const {
        const Plane& plane = planes_[polygon];
        const Eigen::Vector3d away = place - plane.corner;
        const double height = plane.normal.dot(away);
        const double room = plane.room + plane.tilt * away.lpNorm<1>();
        return height > room ? front : height < -room ? back : Side{0};
    }

    /// Part of an edge, relative to the place.
    struct Arc {
        Eigen::Vector3d begin;
        Eigen::Vector3d end;
    };
    enum class Sees : std::uint8_t { nothing, all, part, unclear };

    /// Memory that one call leaves to the next.
    struct Scratch {
        /// Around what is seen, where that is a part, else empty; what is seen lies on the same side of each arc as the
        /// target does of its own edges.
        boost::container::small_vector<Arc, 16> outline;

        // What follows is of use to `find` alone.

        /// An edge that may be part of the outline.
        struct Candidate {
            std::uint32_t cut;
            std::uint32_t rank;  ///< of its polygon
        };
        boost::container::small_vector<double, 320> edges;          ///< table
        boost::container::small_vector<Side, 32> sides;             ///< of the polygons, as in the table
        boost::container::small_vector<std::uint32_t, 32> shadows;  ///< polygons that hide a part of the target
        boost::container::small_vector<SeenEdge, 32> cuts;          ///< their edges that part it, then its own
        boost::container::small_vector<std::uint32_t, 32> ends;     ///< the last cut of each, plus one
        boost::container::small_vector<Candidate, 32> candidates;
        boost::container::small_vector<double, 256> candidate_rows;  ///< table of those, and what is inside of what
    };

    /// @param sides   for each polygon
    /// @param target  its corners relative to the place, which is in front of it; edges are longer than rounding
    /// @pre no polygon reaches behind the target
    /// @return `unclear` where rounding keeps the outline from closing
    Sees find(const Eigen::Vector3d& place, std::span<const Side> sides, std::span<const Eigen::Vector3d> target,
              const Eigen::Vector3d& target_normal, Scratch& scratch) const;

  private:
    struct Plane {
        Eigen::Vector3d normal = Eigen::Vector3d::Zero();
        Eigen::Vector3d corner = Eigen::Vector3d::Zero();
        double room = 0;  ///< rounding of heights near the corner
        double tilt = 0;  ///< and of heights per distance from it
    };
    double rounding_;
    std::vector<Plane> planes_;
    std::vector<std::uint32_t> first_{0};  ///< first edge of each polygon, and one past the last
    std::size_t rows_ = 0;                 ///< of the table of edges
    std::vector<double> edges_;            ///< that table
    std::vector<std::uint32_t> owner_;     ///< polygon of each edge
    std::vector<std::uint32_t> twin_;      ///< the only other edge with the same ends, or itself
    std::vector<Side> twin_sense_;         ///< 1 where it runs the same way, -1 the other way

    void find_twins();
    Sees find_shadows(std::span<const Side> sides, Scratch& scratch) const;
    static bool outline(std::span<const Eigen::Vector3d> target, const Eigen::Vector3d& target_normal,
                        Scratch& scratch);
};

}  // namespace ff
