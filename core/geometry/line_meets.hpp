#pragma once

#include "core/geometry/fwd.hpp"

#include <Eigen/Core>

#include <optional>

namespace ff {

/// The points origin + time * direction. Callers state whether an end lies on the surface: of the two times at which
/// the line meets a curved surface, the one at that end is dropped and the other is computed from it, so that no
/// distance tolerance decides whether a line meets the surface that it starts on.
struct Line {
    Eigen::Vector3d origin;
    Eigen::Vector3d direction;

    [[nodiscard]] Eigen::Vector3d at(double time) const { return origin + time * direction; }
};

/// Which ends of a line, time 0 and time 1, lie on a surface.
struct Ends {
    bool begins = false;  ///< time 0 does, and the line leads to the radiating side
    bool ends = false;    ///< time 1 does, and the line arrives from the radiating side
};

/// Where a line meets a surface.
struct Meeting {
    double time = 0;
    bool outward = false;  ///< curved surfaces only: the line leads away from the axis there (known from the root)
};

/// The first meeting at time 0 or later, computed in double precision; none where there is none. A line never meets a
/// flat surface that an end of it lies on, nor one that bulges.
/// @param rim relative enlargement of round surfaces
std::optional<Meeting> line_meets(const Line& line, const Surface& surface, Ends ends = {}, double rim = 0);

}  // namespace ff
