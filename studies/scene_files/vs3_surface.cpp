#include "studies/scene_files/vs3_surface.hpp"

#include "core/geometry/ear_clipping.hpp"
#include "core/geometry/polygon_parts.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace ff::studies {
namespace {

using Eigen::Vector3d;

constexpr double most_off = 1e-6;  // of a part from the plane and the rim of its base, relative to its size
constexpr std::size_t numbers_of_plane = 5;

bool is_convex(const ConvexPolygon& corners, const Vector3d& normal) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vector3d& next = next_corner(corners, k);
        const Vector3d& last = corners[(k + 2) % corners.size()];
        if ((next - corners[k]).cross(last - next).dot(normal) < 0) return false;
    }
    return true;
}

/// A base as such pieces.
std::vector<ConvexPolygon> convex_pieces(const Vs3Surface& base) {
    if (is_convex(base.corners, base.normal())) return {base.corners};
    std::vector<ConvexPolygon> pieces;
    for (const auto& [a, b, c] : clip_ears(base.corners))
        pieces.push_back({base.corners[a], base.corners[b], base.corners[c]});
    return pieces;
}

}  // namespace

double sine(double degrees) {
    const double turned = std::remainder(degrees, 360.0);
    if (turned == 0 || std::abs(turned) == 180) return 0;
    if (std::abs(turned) == 90) return std::copysign(1.0, turned);
    return std::sin(turned * std::numbers::pi / 180);
}

double cosine(double degrees) {
    return sine(degrees + 90);
}

Vector3d Vs3Surface::normal() const {
    return twice_area(corners).normalized();
}

std::size_t Vs3Shape::wanted() const {
    return numbers_of_plane + (kind == 'R' ? 2U : kind == 'T' ? 6U : 8U);
}

ConvexPolygon Vs3Shape::corners() const {
    const Vector3d origin(numbers[0], numbers[1], numbers[2]);
    const double azimuth = numbers[3], tilt = numbers[4];
    const Vector3d across(-cosine(azimuth), sine(azimuth), 0);
    const Vector3d up(-cosine(tilt) * sine(azimuth), -cosine(tilt) * cosine(azimuth), sine(tilt));
    std::vector<double> plane(numbers.begin() + numbers_of_plane, numbers.end());
    if (kind == 'R') plane = {0, plane[1], 0, 0, plane[0], 0, plane[0], plane[1]};
    ConvexPolygon result;
    for (std::size_t k = 0; k + 1 < plane.size(); k += 2)
        result.emplace_back(origin + plane[k] * across + plane[k + 1] * up);
    return result;
}

std::string problem_on_base(const Vs3Surface& part, const Vs3Surface& base) {
    const Vector3d normal = base.normal();
    const double gap = most_off * length_around(base.corners);
    for (const Vector3d& corner : part.corners) {
        if (std::abs(normal.dot(corner - base.corners[0])) > gap) return "does not lie in the plane of";
    }
    if (!is_convex(part.corners, part.normal())) return "is not convex, on";
    ConvexPolygon outline = part.corners;
    turn_around(outline, normal);
    std::vector<ConvexPolygon> outside{outline};
    for (const ConvexPolygon& piece : convex_pieces(base)) outside = without(outside, piece, normal, gap);
    if (!outside.empty()) return "reaches beyond";
    const bool faces_same_way = part.normal().dot(normal) > 0;
    if (part.kind == 'S') return faces_same_way ? "" : "faces the other way than";
    return faces_same_way ? "does not face" : "";
}

bool overlap(const Vs3Surface& base, const Vs3Surface& a, const Vs3Surface& b) {
    ConvexPolygon first = a.corners;
    ConvexPolygon second = b.corners;
    turn_around(first, base.normal());
    turn_around(second, base.normal());
    return !is_sliver(common_part(first, second, base.normal()), most_off * length_around(first));
}

std::vector<ConvexPolygon> left_of_base(const Vs3Surface& base, const std::vector<const Vs3Surface*>& parts) {
    constexpr double rounding = 1e-9;
    const Vector3d normal = base.normal();
    std::vector<ConvexPolygon> left = convex_pieces(base);
    for (const Vs3Surface* part : parts) {
        ConvexPolygon outline = part->corners;
        turn_around(outline, normal);
        left = without(left, outline, normal, rounding * length_around(base.corners));
    }
    return left;
}

}  // namespace ff::studies
