#pragma once

#include "core/geometry/convex_polygon.hpp"

#include <Eigen/Core>
#include <boost/container/small_vector.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace ff {

/// A plane convex polygon, prepared for tests against many shafts.
class Plate {
  public:
    explicit Plate(const ConvexPolygon& polygon);

  private:
    friend class Shaft;

    /// Places inside of it have inward * (place - corner) > 0.
    struct Edge {
        Eigen::Vector3d corner;
        Eigen::Vector3d inward;  ///< unit length, in the plane
    };
    boost::container::small_vector<Eigen::Vector3d, 4> corners_;
    boost::container::small_vector<Edge, 4> edges_;  ///< without those too short to have a direction
    Eigen::Vector3d normal_;                         ///< unit length; 0 where it has no area
    double size_ = 0;                                ///< longest extent along an axis
    double slenderness_ = 1;                         ///< the square of it over twice the area, at least 1
};

/// All straight lines from a convex set to another. What it proves about a polygon holds for each of them; what it
/// cannot prove may still be true.
class Shaft {
  public:
    /// @param from, to  corners: of a polygon in order, of other sets in any order; at most 8 each. They outlive this.
    /// @param grain     length of the smallest thing that the proof is about: gaps of 1e-15 of it count as none; 0:
    ///                  the length of the shaft
    Shaft(std::span<const Eigen::Vector3d> from, std::span<const Eigen::Vector3d> to, double grain = 0);

    /// How many of the lines a polygon crosses.
    enum class Crossing : std::uint8_t {
        none,  ///< proved to hide nothing
        some,  ///< hides a part, or nothing is proved
        all,   ///< proved to hide everything
    };

    /// `none` where the plane of the polygon, or one through an edge of it, separates it from all lines; `all` where
    /// all lines between corners cross it, which decides for the others since what a convex polygon hides from a place
    /// is convex.
    [[nodiscard]] Crossing crossed_by(const Plate& plate) const;

    /// The same, and `none` also where a side of the shaft does: an axis, the plane of an end, or one through an edge
    /// of one end and a corner of the other. If both are polygons, no other plane can.
    [[nodiscard]] Crossing crossed_by_inside(const Plate& plate);

  private:
    static constexpr std::size_t most_corners = 16;

    std::span<const Eigen::Vector3d> from_;
    std::span<const Eigen::Vector3d> to_;
    std::array<Eigen::Vector3d, most_corners> corners_;  ///< those of `from`, then those of `to`
    std::size_t count_ = 0;
    double size_ = 0;  ///< longest extent along an axis
    double grain_ = 0;

    /// What a length may be off by, and a gap may measure; below 0 where it has to be larger than that.
    struct Slack {
        double noise = 0;
        double gap = 0;
    };
    [[nodiscard]] Slack slack(const Plate& plate) const;
    /// A plane with all lines on the inside.
    struct Side {
        Eigen::Vector3d out;
        double height = 0;  ///< above the first corner
    };
    boost::container::small_vector<Side, 24> sides_;  ///< found when they are first needed

    void find_sides();
};

}  // namespace ff
