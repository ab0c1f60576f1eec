#pragma once

#include "core/geometry/convex_polygon.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace ff {

/// All straight lines from a convex set to a convex polygon. What it proves about a third polygon holds for each of
/// them; what it cannot prove may still be true.
class Shaft {
  public:
    /// @param from, to  corners of convex sets; `from` needs no order
    Shaft(const std::vector<Eigen::Vector3d>& from, const ConvexPolygon& to);

    /// How many of the lines a polygon crosses.
    enum class Crossing : std::uint8_t {
        none,  ///< proved to hide nothing
        some,  ///< hides a part, or nothing is proved
        all,   ///< proved to hide everything
    };

    /// `none` where a plane separates the polygon from all lines; planes through an edge of one and a corner of another
    /// are tried; a gap of 0 counts. Hidden ends of lines from one place are convex, and so are beginnings; hence lines
    /// between corners decide on `all`.
    [[nodiscard]] Crossing crossed_by(const ConvexPolygon& polygon) const;

  private:
    const std::vector<Eigen::Vector3d>& from_;
    const ConvexPolygon& to_;
    double size_ = 0;  ///< the longest extent of any line along an axis

    /// Judged by the lines between corners; `none` where none of them crosses.
    [[nodiscard]] Crossing crossed_between_corners(const ConvexPolygon& polygon, const Eigen::Vector3d& normal) const;
    [[nodiscard]] bool is_parted(const ConvexPolygon& polygon, const Eigen::Vector3d& axis) const;
    /// Judged by a plane along both.
    [[nodiscard]] bool is_parted(const ConvexPolygon& polygon, const Eigen::Vector3d& line,
                                 const Eigen::Vector3d& edge) const;
    [[nodiscard]] bool is_parted_along_an_edge(const ConvexPolygon& polygon) const;
};

}  // namespace ff
