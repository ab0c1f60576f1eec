#pragma once

#include "core/geometry/convex_polygon.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ff::studies {

/// Exact at right angles, where corners of neighbours have to coincide.
double sine(double degrees);
double cosine(double degrees);

/// A surface of a View3D file as a line describes it.
struct Vs3Surface {
    char kind = 'S';  ///< S radiates, O is an obstacle, M masks a part of its base, N removes it
    std::uint64_t line = 0;
    long number = 0;
    long base = 0;      ///< number of the surface that it lies on; 0: none
    long combined = 0;  ///< number of the surface whose face it belongs to; 0: it is a face of its own
    std::optional<double> emissivity;
    std::string name;
    ConvexPolygon corners;

    [[nodiscard]] Eigen::Vector3d normal() const;
};

/// A shape of format 3a: its kind, and numbers that follow on lines of their own.
struct Vs3Shape {
    char kind = 'R';  ///< rectangle, triangle (T) or quadrilateral (Q)
    /// Origin, azimuth (of the direction that it faces, clockwise from y) and tilt (0: it faces upwards) in degrees,
    /// then width and height of a rectangle, or x and y of each corner in its plane.
    std::vector<double> numbers;

    /// How many numbers a shape has.
    [[nodiscard]] std::size_t wanted() const;
    /// @pre all numbers are there
    [[nodiscard]] ConvexPolygon corners() const;
};

/// How a part fits the base that it lies on.
struct FitOnBase {
    std::string problem;  ///< a verb and what goes before the base's name; empty: none
    std::string reason;   ///< text in brackets after a blank; empty where there is nothing to add
    double off = 0;       ///< how far it was moved, or cut off; 0: it is unchanged
};

/// Coordinates with two or three digits behind the point put parts off their bases by some 1e-3 of a wall's size.
inline constexpr double most_off_base = 2e-3;

/// Moves a part into the plane of its base, and cuts off what reaches beyond it, as far as that counts as rounding. A
/// part is convex, lies within its base, and faces the same way as the base where it radiates, the other way where it
/// faces the base.
/// @param most_off  largest displacement that counts as rounding, in units of length
FitOnBase fit_on_base(Vs3Surface& part, const Vs3Surface& base, double most_off);

/// The largest distance between corners.
double size_of(const ConvexPolygon& corners);

/// Whether two parts of a base overlap.
bool overlap(const Vs3Surface& base, const Vs3Surface& a, const Vs3Surface& b);

/// The rest of a surface beside the parts that lie on it, in convex pieces; without parts the surface itself,
/// convex or not.
std::vector<ConvexPolygon> left_of_base(const Vs3Surface& base, const std::vector<const Vs3Surface*>& parts);

}  // namespace ff::studies
