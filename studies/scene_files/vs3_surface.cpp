#include "studies/scene_files/vs3_surface.hpp"

#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/ear_clipping.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

namespace ff::studies {
namespace {

using Eigen::Vector3d;

/// How far a part may be off the plane and the rim of its base, relative to the length around the base or the part.
constexpr double unnoticed = 1e-6;
constexpr std::size_t numbers_of_plane = 5;

bool is_convex(const ConvexPolygon& corners, const Vector3d& normal) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vector3d& next = next_corner(corners, k);
        const Vector3d& last = corners[(k + 2) % corners.size()];
        if ((next - corners[k]).cross(last - next).dot(normal) < 0) return false;
    }
    return true;
}

/// A base as convex pieces.
std::vector<ConvexPolygon> convex_pieces(const Vs3Surface& base) {
    if (is_convex(base.corners, base.normal())) return {base.corners};
    std::vector<ConvexPolygon> pieces;
    for (const auto& [a, b, c] : clip_ears(base.corners))
        pieces.push_back({base.corners[a], base.corners[b], base.corners[c]});
    return pieces;
}

/// How far a part reaches beyond the pieces of its base: its corners, or a strip between them. 0: less than the gap
double reach_beyond(const ConvexPolygon& part, const std::vector<ConvexPolygon>& pieces, const Vector3d& normal,
                    double gap) {
    std::vector<ConvexPolygon> outside{part};
    for (const ConvexPolygon& piece : pieces) outside = without(outside, piece, normal, gap);
    double reach = 0;
    for (const ConvexPolygon& strip : outside)
        reach = std::max(reach, 2 * polygon_area(strip) / length_around(strip));  // the width of a long one
    if (outside.empty()) return reach;
    for (const Vector3d& corner : part) {
        double off = std::numeric_limits<double>::infinity();
        for (const ConvexPolygon& piece : pieces) off = std::min(off, distance(corner, piece, normal));
        reach = std::max(reach, off);
    }
    return reach;
}

/// A part without what lies beyond the edges of its base by at most this length.
ConvexPolygon cut_at_rim(ConvexPolygon part, const ConvexPolygon& base, const Vector3d& normal, double most_off) {
    for (std::size_t k = 0; k < base.size(); ++k) {
        const Vector3d inwards = normal.cross(next_corner(base, k) - base[k]).normalized();
        double beyond = 0;
        for (const Vector3d& corner : part) beyond = std::max(beyond, inwards.dot(base[k] - corner));
        // A part lies far beyond the line of an edge that it is not beside, where its base is not convex.
        if (beyond > 0 && beyond <= most_off) part = clipped(part, inwards, inwards.dot(base[k]));
    }
    return part;
}

FitOnBase misfit(std::string_view problem, double off, double most_off) {
    return {std::string(problem), fmt::format(" (it is {:.3g} off; up to {:.2g} counts as rounding)", off, most_off),
            off};
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

double size_of(const ConvexPolygon& corners) {
    double size = 0;
    for (const Vector3d& a : corners) {
        for (const Vector3d& b : corners) size = std::max(size, (b - a).norm());
    }
    return size;
}

FitOnBase fit_on_base(Vs3Surface& part, const Vs3Surface& base, double most_off) {
    const Vector3d normal = base.normal();
    const double gap = unnoticed * length_around(base.corners);
    most_off = std::max(most_off, gap);
    FitOnBase fit;
    for (const Vector3d& corner : part.corners)
        fit.off = std::max(fit.off, std::abs(normal.dot(corner - base.corners[0])));
    if (fit.off > most_off) return misfit("does not lie in the plane of", fit.off, most_off);
    if (!is_convex(part.corners, part.normal())) return {"is not convex, on", "", 0};
    const bool faces_same_way = part.normal().dot(normal) > 0;
    if (part.kind == 'S' && !faces_same_way) return {"faces the other way than", "", 0};
    if (part.kind != 'S' && faces_same_way) return {"does not face", "", 0};

    // Where no difference is noticeable, corners stay as they are: neighbours may share them.
    if (fit.off <= gap) fit.off = 0;
    if (fit.off > 0) {
        for (Vector3d& corner : part.corners) corner -= normal.dot(corner - base.corners[0]) * normal;
    }
    ConvexPolygon outline = part.corners;
    turn_around(outline, normal);
    const std::vector<ConvexPolygon> pieces = convex_pieces(base);
    const double reach = reach_beyond(outline, pieces, normal, gap);
    if (reach == 0) return fit;
    if (reach > most_off) return misfit("reaches beyond", reach, most_off);
    outline = cut_at_rim(outline, base.corners, normal, most_off);
    if (const double left = reach_beyond(outline, pieces, normal, gap); left > 0 || outline.empty())
        return misfit("reaches beyond", reach, most_off);
    part.corners = outline;
    if (!faces_same_way) std::reverse(part.corners.begin(), part.corners.end());
    fit.off = std::max(fit.off, reach);
    return fit;
}

bool overlap(const Vs3Surface& base, const Vs3Surface& a, const Vs3Surface& b) {
    ConvexPolygon first = a.corners;
    ConvexPolygon second = b.corners;
    turn_around(first, base.normal());
    turn_around(second, base.normal());
    return !is_sliver(common_part(first, second, base.normal()), unnoticed * length_around(first));
}

std::vector<ConvexPolygon> left_of_base(const Vs3Surface& base, const std::vector<const Vs3Surface*>& parts) {
    if (parts.empty()) return {base.corners};
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
