#pragma once

#include <Eigen/Core>

#include <vector>

namespace ff {

/// Corners of a plane convex polygon, in order around it.
using ConvexPolygon = std::vector<Eigen::Vector3d>;

/// All straight lines from a convex set to a convex polygon. What it proves of a third polygon holds for every one of
/// them; what it does not prove may be so all the same.
class Shaft {
  public:
    /// @param from, to  corners of convex sets; `from` needs no order
    Shaft(const std::vector<Eigen::Vector3d>& from, const ConvexPolygon& to);

    /// Whether a plane parts the polygon from all lines: it hides nothing. Planes through an edge of one of the three
    /// and a corner of another are tried; a gap of 0 is a gap.
    [[nodiscard]] bool keeps_clear_of(const ConvexPolygon& polygon) const;

    /// Whether every line crosses the polygon: it hides everything. Of lines from one place the ends that a convex
    /// polygon hides are convex, and of lines to one place their beginnings are: the lines between corners decide.
    [[nodiscard]] bool is_closed_by(const ConvexPolygon& polygon) const;

  private:
    const std::vector<Eigen::Vector3d>& from_;
    const ConvexPolygon& to_;
    double size_ = 0;  ///< the lines are nowhere longer along an axis

    [[nodiscard]] bool is_parted(const ConvexPolygon& polygon, const Eigen::Vector3d& axis) const;
    /// By a plane along both.
    [[nodiscard]] bool is_parted(const ConvexPolygon& polygon, const Eigen::Vector3d& line,
                                 const Eigen::Vector3d& edge) const;
};

/// From a place to the nearest point of a polygon.
double distance(const Eigen::Vector3d& place, const ConvexPolygon& polygon);

double area(const ConvexPolygon& polygon);

/// The part of a convex polygon where normal * v >= offset; empty where there is none.
ConvexPolygon clipped(const ConvexPolygon& polygon, const Eigen::Vector3d& normal, double offset);

}  // namespace ff
