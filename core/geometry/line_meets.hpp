#pragma once

#include "core/geometry/scene.hpp"

#include <Eigen/Core>

#include <optional>

namespace ff {

/// The points origin + time * direction. Where an end of it lies on a surface, that is known, not found out: of the
/// two times at which the line meets a curved surface, the one at the end is left out and the other one computed from
/// it, so that no distance decides whether a line meets the surface it starts on.
struct Line {
    Eigen::Vector3d origin;
    Eigen::Vector3d direction;

    [[nodiscard]] Eigen::Vector3d at(double time) const { return origin + time * direction; }
};

/// Which ends of a line, time 0 and time 1, lie on a surface.
struct Ends {
    bool begins = false;  ///< and leads to the radiating side
    bool ends = false;    ///< and arrives from the radiating side
};

/// Where a line meets a surface.
struct Meeting {
    double time = 0;
    bool outward = false;  ///< of curved surfaces: the line leads away from the axis there, known from which root it is
};

/// The first meeting at time 0 or later, computed in double precision; none where there is none. A line never meets a
/// flat surface that an end of it lies on, nor one that bulges.
/// @param rim  by which share of its size a round surface is taken for larger than it is
std::optional<Meeting> line_meets(const Line& line, const Surface& surface, Ends ends = {}, double rim = 0);

}  // namespace ff
