#include "studies/form_factors/cells/part_bounds.hpp"

#include "core/geometry/shaft.hpp"
#include "core/geometry/surface_map.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ff::studies::form_factors {

using Eigen::Vector3d;

PartBounds::Polygon::Polygon(ConvexPolygon polygon)
    : corners(std::move(polygon)), normal(twice_area(corners)), area(normal.norm() / 2) {}

/// What lies below the horizon of a flat source neither sends nor hides anything.
ConvexPolygon PartBounds::above_horizon(const Surface& surface, const Vector3d& origin) const {
    ConvexPolygon result = corners(surface.shape);
    for (Vector3d& corner : result) corner -= origin;
    if (!is_flat(source_.shape)) return result;
    return clipped(result, source_.normal, extent(source_, source_.normal).high - source_.normal.dot(origin));
}

PartBounds::PartBounds(const Surface& source, const BlockedPair& pair, const std::vector<RimEdge>& rim,
                       std::size_t blockers)
    : source_(source), is_plane_(true), target_(pair.target), rims_(source_, target_.corners) {
    std::vector<std::vector<Rims::Edge>> edges(blockers);
    for (const RimEdge& edge : rim) edges[pair.indices[edge.blocker]].push_back({edge.a, edge.b});
    for (const std::vector<Rims::Edge>& of_blocker : edges) rims_.add_blocker(of_blocker);
    blockers_.resize(blockers, Polygon({}));
    for (std::size_t b = 0; b < pair.blockers.size(); ++b) blockers_[pair.indices[b]] = Polygon(pair.blockers[b]);
}

PartBounds::PartBounds(const Surface& source, const Surface& target, const std::vector<Blocker>& blockers,
                       const Vector3d& origin)
    : source_(source), is_plane_(false), target_(above_horizon(target, origin)), rims_(source_, target_.corners) {
    if (target_.corners.empty()) return;
    // A blocker can stand between where it is before the target, and in the box around both.
    Eigen::AlignedBox3d box = box_around(source);
    box.translate(-origin);
    for (const Vector3d& corner : target_.corners) box.extend(corner);
    for (const Blocker& blocker : blockers) {
        ConvexPolygon part =
            clipped(above_horizon(*blocker.surface, origin), target.normal, target.normal.dot(target_.corners.front()));
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            const Vector3d along = Vector3d::Unit(axis);
            part = clipped(clipped(part, along, box.min()[axis]), -along, -box.max()[axis]);
        }
        rims_.add_blocker(edges_of(part));
        blockers_.emplace_back(std::move(part));
    }
}

std::vector<std::uint32_t> PartBounds::blockers() const {
    std::vector<std::uint32_t> result;
    for (std::uint32_t b = 0; b < blockers_.size(); ++b) {
        if (!blockers_[b].corners.empty()) result.push_back(b);
    }
    return result;
}

/// An upper bound of the factor to a polygon from any place of the part.
double PartBounds::most_to(const Polygon& polygon, const PartExtent& part) const {
    const double away = distance(part.centre, polygon.corners, polygon.normal) - part.radius;
    if (!(away > 0)) return 1;
    const double over_polygon =
        std::abs(polygon.normal.dot(part.centre - polygon.corners.front())) / (2 * polygon.area) + part.radius;
    double height = away;
    if (is_flat(source_.shape)) {
        height = 0;
        for (const Vector3d& corner : polygon.corners)
            height = std::max(height, source_.normal.dot(corner - part.centre));
    }
    const auto cosine = [&](double above) { return std::min(1.0, above / away); };
    return std::min(1.0, polygon.area / (std::numbers::pi * away * away) * cosine(height) * cosine(over_polygon));
}

PartBounds::Bounds PartBounds::of(const PartExtent& part, std::span<const std::uint32_t> blockers) const {
    Bounds result;
    if (target_.corners.empty()) return result;
    Shaft shaft(part.hull, target_.corners);
    bool hides_all = false;
    for (const std::uint32_t b : blockers) {
        const Plate plate(blockers_[b].corners);
        const Shaft::Crossing crossing = shaft.crossed_by(plate);
        if (crossing == Shaft::Crossing::none) continue;
        hides_all = hides_all || (is_plane_ && crossing == Shaft::Crossing::all);
        if (!shaft.is_beside(plate)) result.blockers.push_back(b);
    }
    constexpr double small = 0.5;
    const double away = distance(part.centre, target_.corners, target_.normal) - part.radius;
    if (result.blockers.empty() && 2 * part.radius <= small * away) return result;
    const double whole = most_to(target_, part);
    double hidden = 0;
    for (const std::uint32_t b : result.blockers) hidden += most_to(blockers_[b], part);
    result.visible = hides_all ? 0 : whole;
    result.hidden = std::min(whole, hidden);
    const double slope = rims_.slope(part, hides_all ? std::span<const std::uint32_t>() : result.blockers);
    result.change = 2 * part.turn + (slope < HUGE_VAL ? slope * part.size : HUGE_VAL);
    return result;
}

}  // namespace ff::studies::form_factors
