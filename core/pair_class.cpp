#include "core/pair_class.hpp"

#include "core/contract.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ff {
namespace {

using Eigen::Vector3d;

/// Room for rounding, relative to the surfaces.
constexpr double tolerance = 1e-12;

struct Line {
    Vector3d point;
    Vector3d direction;  ///< unit length
};

/// The part of a line between two positions along it; empty unless begin < end.
struct Stretch {
    double begin = -std::numeric_limits<double>::infinity();
    double end = std::numeric_limits<double>::infinity();
};

constexpr Stretch nowhere{0, 0};

Stretch intersect(const Stretch& a, const Stretch& b) {
    return {std::max(a.begin, b.begin), std::min(a.end, b.end)};
}

double size(const Parallelogram& shape) {
    return shape.edge_u.norm() + shape.edge_v.norm();
}

bool are_parallel(const Surface& a, const Surface& b) {
    return a.normal.cross(b.normal).norm() <= tolerance;
}

/// Where the planes of two surfaces meet. @pre the surfaces are not parallel
Line common_line(const Surface& a, const Surface& b) {
    const Vector3d direction = a.normal.cross(b.normal).normalized();
    // Measured from a's corner, so that rounding is relative to the surfaces and not to the origin.
    Eigen::Matrix3d planes;
    planes << a.normal.transpose(), b.normal.transpose(), direction.transpose();
    const Vector3d offsets(0, b.normal.dot(b.shape.corner - a.shape.corner), 0);
    return {a.shape.corner + planes.partialPivLu().solve(offsets), direction};
}

/// The part of `line` (in the plane of the strip) between an edge and its opposite: 0 <= (x - corner) . across <= 1.
Stretch inside_strip(const Line& line, const Vector3d& corner, const Vector3d& across) {
    const double start = (line.point - corner).dot(across);
    const double slope = line.direction.dot(across);
    if (std::abs(slope) <= tolerance * across.norm()) {
        return start >= -tolerance && start <= 1 + tolerance ? Stretch{} : nowhere;
    }
    const auto [begin, end] = std::minmax({-start / slope, (1 - start) / slope});
    return {begin, end};
}

/// The part of `line` (in the plane of the shape) on a parallelogram, rim included.
Stretch inside(const Line& line, const Parallelogram& shape) {
    const Vector3d normal = shape.edge_u.cross(shape.edge_v);
    // Dual basis: the coordinates of a point x of the shape are s = (x - corner) . across_u, t = (x - corner) .
    // across_v.
    const Vector3d across_u = shape.edge_v.cross(normal) / normal.squaredNorm();
    const Vector3d across_v = normal.cross(shape.edge_u) / normal.squaredNorm();
    return intersect(inside_strip(line, shape.corner, across_u), inside_strip(line, shape.corner, across_v));
}

bool meet_along_line(const Surface& a, const Surface& b) {
    if (are_parallel(a, b)) return false;
    const Line line = common_line(a, b);
    const Stretch shared = intersect(inside(line, a.shape), inside(line, b.shape));
    return shared.end - shared.begin > tolerance * std::min(size(a.shape), size(b.shape));
}

}  // namespace

std::string_view name(PairClass pair_class) {
    switch (pair_class) {
        case PairClass::self:
            return "self";
        case PairClass::parallel:
            return "parallel";
        case PairClass::adjacent:
            return "adjacent";
        case PairClass::other:
            break;
    }
    return "other";
}

PairClass pair_class(const Scene& scene, int from_face, int to_face) {
    FF_EXPECT(from_face >= 0 && static_cast<std::size_t>(from_face) < scene.faces.size());
    FF_EXPECT(to_face >= 0 && static_cast<std::size_t>(to_face) < scene.faces.size());
    if (from_face == to_face) return PairClass::self;
    bool all_parallel = true;
    for (const Surface& from : scene.surfaces) {
        if (from.face != from_face) continue;
        for (const Surface& to : scene.surfaces) {
            if (to.face != to_face) continue;
            if (meet_along_line(from, to)) return PairClass::adjacent;
            all_parallel = all_parallel && are_parallel(from, to);
        }
    }
    return all_parallel ? PairClass::parallel : PairClass::other;
}

}  // namespace ff
