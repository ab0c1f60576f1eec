#include "core/visibility/visible_polygon.hpp"

#include "core/support/contract.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace ff {
namespace {

using Eigen::Vector3d;
using Polygon = std::vector<Vector3d>;

/// The part of a convex polygon where normal * v >= offset; fewer than three corners where there is none.
void clip(const Polygon& polygon, const Vector3d& normal, double offset, Polygon& result) {
    result.clear();
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vector3d& a = polygon[k];
        const Vector3d& b = polygon[k + 1 == polygon.size() ? 0 : k + 1];
        const double before = normal.dot(a) - offset;
        const double after = normal.dot(b) - offset;
        if (before >= 0) result.push_back(a);
        if ((before > 0 && after < 0) || (before < 0 && after > 0))
            result.push_back(a + (b - a) * (before / (before - after)));
    }
    if (result.size() < 3) result.clear();
}

/// Lambert's formula from the origin. @pre the polygon is above the horizon
double factor_of(const Polygon& polygon, const Vector3d& normal) {
    double sum = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vector3d& a = polygon[k];
        const Vector3d& b = polygon[k + 1 == polygon.size() ? 0 : k + 1];
        const Vector3d across = a.cross(b);
        const double sine = across.norm();
        if (sine > 0) sum += std::atan2(sine, a.dot(b)) * across.dot(normal) / sine;
    }
    return sum / (2 * std::numbers::pi);
}

/// Room for the rounding of a triple product, relative to the lengths of its factors.
constexpr double rounding = 4e-15;

/// Planes through the origin and the edges of a polygon, normals towards its inside; none where it is seen edge-on, or
/// so nearly that rounding decides where its inside is.
void find_sides(const Polygon& polygon, Polygon& sides) {
    sides.clear();
    Vector3d middle = Vector3d::Zero();
    for (const Vector3d& corner : polygon) middle += corner;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vector3d& a = polygon[k];
        const Vector3d& b = polygon[k + 1 == polygon.size() ? 0 : k + 1];
        Vector3d side = a.cross(b);
        const double room = rounding * rounding * a.squaredNorm() * b.squaredNorm();
        if (side.squaredNorm() <= room) continue;  // two corners in one
        const double height = side.dot(middle);
        if (height * height <= room * middle.squaredNorm()) {
            sides.clear();
            return;
        }
        sides.push_back(height > 0 ? side : -side);
    }
    if (sides.size() < 3) sides.clear();
}

bool is_outside(const Polygon& piece, const Polygon& sides) {
    return std::any_of(sides.begin(), sides.end(), [&](const Vector3d& side) {
        return std::all_of(piece.begin(), piece.end(), [&](const Vector3d& v) { return side.dot(v) <= 0; });
    });
}

/// Cuts what lies between `sides` out of convex pieces; what is left is convex pieces again.
void cut_out(const Polygon& sides, std::vector<Polygon>& pieces, std::vector<Polygon>& left) {
    left.clear();
    Polygon inside;
    Polygon outside;
    for (Polygon& piece : pieces) {
        if (is_outside(piece, sides)) {
            left.push_back(std::move(piece));
            continue;
        }
        for (const Vector3d& side : sides) {
            clip(piece, -side, 0, outside);
            if (!outside.empty()) left.push_back(outside);
            clip(piece, side, 0, inside);
            std::swap(piece, inside);
            if (piece.empty()) break;
        }
    }
    std::swap(pieces, left);
}

Polygon around(const Surface& surface) {
    Polygon polygon = corners(surface.shape);
    FF_EXPECT(polygon.size() >= 3);
    const Vector3d across = (polygon[1] - polygon[0]).cross(polygon[2] - polygon[1]);
    if (across.dot(surface.normal) < 0) std::reverse(polygon.begin(), polygon.end());
    return polygon;
}

}  // namespace

VisiblePolygon::VisiblePolygon(const Surface& target, const std::vector<const Surface*>& blockers)
    : target_(around(target)), target_normal_(target.normal) {
    for (const Surface* blocker : blockers) blockers_.push_back(around(*blocker));
    all_.resize(blockers_.size());
    std::iota(all_.begin(), all_.end(), 0U);
}

VisiblePolygon::Factors VisiblePolygon::from(const Vector3d& place, const Vector3d& normal) const {
    return from(place, normal, all_);
}

VisiblePolygon::Factors VisiblePolygon::from(const Vector3d& place, const Vector3d& normal,
                                             std::span<const std::uint32_t> blockers) const {
    const double plane = target_normal_.dot(target_.front() - place);  // its height above the place
    if (plane >= 0) return {};
    Polygon moved;
    Polygon clipped;
    const auto move = [&](const Polygon& polygon) {
        moved.clear();
        for (const Vector3d& corner : polygon) moved.emplace_back(corner - place);
    };
    move(target_);
    clip(moved, normal, 0, clipped);
    if (clipped.empty()) return {};
    // Corners run clockwise as seen from the place that the polygon's normal points to.
    const Factors nothing_between{-factor_of(clipped, normal), 0};
    std::vector<Polygon> pieces{clipped};
    std::vector<Polygon> left;
    Polygon sides;
    for (const std::uint32_t index : blockers) {
        const Polygon& blocker = blockers_[index];
        // In its way is what stands above the horizon and before the target's plane.
        move(blocker);
        clip(moved, normal, 0, clipped);
        clip(clipped, target_normal_, plane, moved);
        if (moved.empty()) continue;
        find_sides(moved, sides);
        if (!sides.empty()) cut_out(sides, pieces, left);
        if (pieces.empty()) break;
    }
    double visible = 0;
    for (const Polygon& piece : pieces) visible -= factor_of(piece, normal);
    return {nothing_between.whole, visible};
}

}  // namespace ff
