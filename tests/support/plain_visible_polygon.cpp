#include "tests/support/plain_visible_polygon.hpp"

#include "core/geometry/convex_polygon.hpp"
#include "core/geometry/scene.hpp"
#include "core/support/contract.hpp"

#include <Eigen/Geometry>
#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <utility>

namespace ff::test {
namespace {

using Eigen::Vector3d;
/// Few corners, so that none of them is allocated.
using SmallPolygon = boost::container::small_vector<Vector3d, 10>;

/// Relative to `place`.
SmallPolygon seen_from(const Vector3d& place, std::span<const Vector3d> polygon) {
    SmallPolygon result;
    result.resize(polygon.size(), Vector3d::Zero());
    for (std::size_t k = 0; k < polygon.size(); ++k) result[k] = polygon[k] - place;
    return result;
}

/// The part of a convex polygon that is above a plane. Where the edge to its first corner crosses the plane, the part
/// begins there: sums are added up in that order.
template <class Height>
SmallPolygon part_of(const SmallPolygon& polygon, const Height& height) {
    SmallPolygon part = part_above(polygon, height);
    if (!part.empty() && height(polygon.back()) * height(polygon.front()) < 0)
        std::rotate(part.begin(), part.end() - 1, part.end());
    return part;
}

/// Takes the part where normal * v < 0 off a convex polygon. @return whether there is one; what is left may be empty
/// @param room  corners no farther than this from the plane lie in it
bool cut(SmallPolygon& polygon, const Vector3d& normal, double room = 0) {
    const auto height = [&](const Vector3d& v) {
        const double above = normal.dot(v);
        return std::abs(above) <= room ? 0 : above;
    };
    if (std::none_of(polygon.begin(), polygon.end(), [&](const Vector3d& v) { return height(v) < 0; })) return false;
    polygon = part_of(polygon, height);
    return true;
}

/// The same. @return that part
SmallPolygon cut_off(SmallPolygon& polygon, const Vector3d& normal) {
    const SmallPolygon whole = polygon;
    return cut(polygon, normal) ? part_of(whole, [&](const Vector3d& v) { return -normal.dot(v); }) : SmallPolygon();
}

/// Lambert's formula from the origin. @pre the polygon is above the horizon
double factor_of(const SmallPolygon& polygon, const Vector3d& normal) {
    double sum = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vector3d& a = polygon[k];
        const Vector3d& b = next_corner(polygon, k);
        const Vector3d across = a.cross(b);
        const double sine = across.norm();
        if (sine > 0) sum += std::atan2(sine, a.dot(b)) * across.dot(normal) / sine;
    }
    return sum / (2 * std::numbers::pi);
}

/// A polygon that touches a plane may lie a little behind it by rounding. Cut off there, it would get an edge between
/// two coinciding corners, whose direction is arbitrary.
void cut_at_plane(SmallPolygon& polygon, const Vector3d& normal) {
    constexpr double rounding = 1e-13;
    double farthest = 0;
    for (const Vector3d& corner : polygon) farthest = std::max(farthest, corner.norm());
    cut(polygon, normal, rounding * farthest);
}

/// Room for the rounding of a triple product, relative to the lengths of its factors.
constexpr double product_rounding = 4e-15;

/// Planes through the origin and the edges of a polygon, normals towards its inside; none where it is seen edge-on, or
/// so nearly that rounding decides where its inside is.
SmallPolygon sides_of(const SmallPolygon& polygon) {
    Vector3d middle = Vector3d::Zero();
    for (const Vector3d& corner : polygon) middle += corner;
    SmallPolygon sides;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vector3d& a = polygon[k];
        const Vector3d& b = next_corner(polygon, k);
        Vector3d side = a.cross(b);
        const double room = product_rounding * product_rounding * a.squaredNorm() * b.squaredNorm();
        if (side.squaredNorm() <= room) continue;  // two corners in one
        const double height = side.dot(middle);
        if (height * height <= room * middle.squaredNorm()) return {};
        sides.push_back(height > 0 ? side : -side);
    }
    if (sides.size() < 3) sides.clear();
    return sides;
}

bool is_outside(const SmallPolygon& piece, const SmallPolygon& sides) {
    return std::any_of(sides.begin(), sides.end(), [&](const Vector3d& side) {
        return std::all_of(piece.begin(), piece.end(), [&](const Vector3d& v) { return side.dot(v) <= 0; });
    });
}

/// Factor of the part of a convex piece that is in a shadow, given by the planes of its sides.
/// @param factor  of the whole piece
double factor_of_hidden(const SmallPolygon& piece, double factor, const SmallPolygon& shadow, const Vector3d& normal) {
    SmallPolygon hidden = piece;
    bool differs = false;
    for (const Vector3d& side : shadow) {
        differs = cut(hidden, side) || differs;
        if (hidden.empty()) return 0;
    }
    return differs ? factor_of(hidden, normal) : factor;
}

/// Form factor of the part of a convex piece that no shadow hides.
double factor_of_visible(SmallPolygon piece, std::span<const SmallPolygon> shadows, const Vector3d& normal) {
    while (!shadows.empty() && is_outside(piece, shadows.front())) shadows = shadows.subspan(1);
    if (shadows.size() < 2) {
        const double factor = factor_of(piece, normal);
        return shadows.empty() ? factor : factor - factor_of_hidden(piece, factor, shadows.front(), normal);
    }
    double sum = 0;
    for (const Vector3d& side : shadows.front()) {
        SmallPolygon outside = cut_off(piece, side);
        if (!outside.empty()) sum += factor_of_visible(std::move(outside), shadows.subspan(1), normal);
        if (piece.empty()) break;
    }
    return sum;
}

}  // namespace

PlainVisiblePolygon::PlainVisiblePolygon(const Surface& target, const std::vector<Blocker>& blockers)
    : target_(outline(target)), target_normal_(target.normal) {
    FF_EXPECT(!target_.empty());
    // Parts of blockers that lie behind the target's plane hide nothing.
    const Vector3d origin = target_.front();
    for (const Blocker& blocker : blockers) {
        FF_EXPECT(!corners(blocker.surface->shape).empty());
        SmallPolygon part = seen_from(origin, outline(*blocker.surface));
        cut_at_plane(part, target_normal_);
        std::vector<Vector3d>& kept = blockers_.emplace_back();
        for (const Vector3d& corner : part) kept.emplace_back(origin + corner);
    }
    all_.resize(blockers_.size());
    std::iota(all_.begin(), all_.end(), 0U);
}

PlainVisiblePolygon::Factors PlainVisiblePolygon::from(const Vector3d& place, const Vector3d& normal) const {
    return from(place, normal, all_);
}

PlainVisiblePolygon::Factors PlainVisiblePolygon::from(const Vector3d& place, const Vector3d& normal,
                                                       std::span<const std::uint32_t> blockers) const {
    if (target_normal_.dot(target_.front() - place) >= 0) return {};
    SmallPolygon whole = seen_from(place, target_);
    cut_at_plane(whole, normal);
    if (whole.empty()) return {};
    const SmallPolygon cone = sides_of(whole);
    boost::container::small_vector<SmallPolygon, 4> shadows;
    for (const std::uint32_t index : blockers) {
        // Its part below the horizon hides nothing either, so that it need not be cut off.
        const SmallPolygon blocker = seen_from(place, blockers_[index]);
        if (is_outside(blocker, cone)) continue;
        SmallPolygon sides = sides_of(blocker);
        if (!sides.empty() && !is_outside(whole, sides)) shadows.push_back(std::move(sides));
    }
    // Corners run clockwise as seen from the place that the polygon's normal points to.
    const double factor = -factor_of(whole, normal);
    if (shadows.empty()) return {factor, factor};
    if (shadows.size() == 1) return {factor, factor + factor_of_hidden(whole, -factor, shadows.front(), normal)};
    return {factor, -factor_of_visible(std::move(whole), {shadows.data(), shadows.size()}, normal)};
}

}  // namespace ff::test
