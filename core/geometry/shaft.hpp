#pragma once

#include "core/geometry/convex_polygon.hpp"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ff {

/// A plane convex polygon, prepared for tests against many shafts.
struct Plate {
    /// Places inside of it have inward * (place - corner) > 0.
    struct Edge {
        Eigen::Vector3d corner;
        Eigen::Vector3d inward;  ///< unit length, in the plane
        std::size_t index = 0;   ///< number of the corner, in order around the polygon
    };
    ConvexPolygon corners;
    std::vector<Edge> edges;  ///< without those too short to have a direction
    Eigen::Vector3d normal;   ///< unit length; 0 where the polygon has no area
    double size = 0;          ///< longest extent along an axis
    double slenderness = 1;   ///< the square of it over twice the area, at least 1

    explicit Plate(const ConvexPolygon& polygon);
};

/// All straight lines from a convex set to another. What it proves about a polygon holds for each of them; what it
/// cannot prove may still be true.
class Shaft {
  public:
    /// @param from, to  corners: of a polygon in order, of other sets in any order; at most 8 each. They outlive this.
    /// @param grain  size of the smallest thing that the proof is about: gaps of 1e-15 of it do not count; 0: the
    /// length of the shaft
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

    /// Edges of a polygon that lines may pass on either side, as bits by the index of their first corner. All lines
    /// that cross its plane do so inside of the others.
    [[nodiscard]] std::uint32_t open_edges(const Plate& plate) const;

    /// Whether a side of the shaft separates a polygon from all lines: a plane across an axis, the plane of an end, or
    /// one through an edge of one end and a corner of the other. If both ends are polygons, one that no line crosses is
    /// shown to be beside it, or `crossed_by` shows it.
    [[nodiscard]] bool is_beside(const Plate& plate);

    /// Whether either of the two proves that no line crosses a polygon.
    [[nodiscard]] bool is_clear_of(const Plate& plate) {
        return crossed_by(plate) == Crossing::none || is_beside(plate);
    }

    static constexpr std::size_t most_corners = 16;

    /// The corners of both ends: those of `from`, then those of `to`, the last one repeated up to a multiple of eight.
    struct Corners {
        using Component = std::array<double, most_corners>;
        alignas(64) Component x, y, z;
        alignas(64) Component end;  ///< 1 for those of `from`, -1 for those of `to`
        std::size_t count = 0;
    };

    /// Allowance for the error of a length, and for a gap; below 0 where a length has to be larger than that.
    struct Slack {
        double noise = 0;
        double gap = 0;
    };

  private:
    std::span<const Eigen::Vector3d> from_;
    std::span<const Eigen::Vector3d> to_;
    Corners corners_;
    double size_ = 0;  ///< longest extent along an axis
    double grain_ = 0;

    [[nodiscard]] Slack slack(const Plate& plate) const;
    /// A plane with all lines on the inside.
    struct Side {
        Eigen::Vector3d out;
        double height = 0;  ///< height of the plane above the first corner
    };
    std::vector<Side> sides_;  ///< found when they are first needed

    [[nodiscard]] Eigen::Vector3d corner(std::size_t k) const { return {corners_.x[k], corners_.y[k], corners_.z[k]}; }
    void find_sides();
    void add_side(const Eigen::Vector3d& at, const Eigen::Vector3d& out);
};

}  // namespace ff
