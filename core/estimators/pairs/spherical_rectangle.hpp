#pragma once

#include <Eigen/Core>

namespace ff {

/// A rectangle as seen from the origin: corners (x, y) to (x + width, y + height) in a plane at a distance.
/// @pre width, height, distance > 0
struct SeenRectangle {
    double x = 0;
    double y = 0;
    double width = 0;
    double height = 0;
    double distance = 0;
};

/// Half the solid angle, in steradians; 0 to pi. Keeps all digits where it is small. @see [vanoosterom1983]
double half_solid_angle(const SeenRectangle& seen);

/// The place at (s, t) in [0, 1]^2, from the corner, a map that keeps shares of solid angle: `s` moves a line along the
/// width, `t` leads along the line. Smooth in both, and the same bits on every CPU. @see [urena2013]
/// @param half_area  its half_solid_angle
Eigen::Vector2d place_in(const SeenRectangle& seen, double half_area, double s, double t);

}  // namespace ff
