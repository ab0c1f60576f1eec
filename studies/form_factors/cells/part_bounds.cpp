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
using std::numbers::pi;

namespace {

/// Planes through the middle of a part and the edges of a polygon, with normals of unit length that lead out.
std::vector<Vector3d> cone_of(const PartExtent& part, const ConvexPolygon& polygon) {
    Vector3d middle = Vector3d::Zero();
    for (const Vector3d& corner : polygon) middle += corner / static_cast<double>(polygon.size());
    std::vector<Vector3d> planes;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vector3d& next = next_corner(polygon, k);
        const Vector3d across = (polygon[k] - part.centre).cross(next - part.centre).normalized();
        const double inside = across.dot(middle - part.centre);
        const auto leads_out = [&](const Vector3d& normal) {
            return std::all_of(polygon.begin(), polygon.end(), [&](const Vector3d& corner) {
                return normal.dot(corner - part.centre) <= 1e-12 * (corner - part.centre).norm();
            });
        };
        const Vector3d normal = inside > 0 ? -across : across;
        if (normal.squaredNorm() > 0.5 && leads_out(normal)) planes.push_back(normal);
    }
    return planes;
}

}  // namespace

std::vector<RimEdge> edges_of(const ConvexPolygon& polygon) {
    std::vector<RimEdge> result;
    for (std::size_t k = 0; k < polygon.size(); ++k) result.push_back({polygon[k], next_corner(polygon, k)});
    return result;
}

Rims::Rims(const Surface& source, const ConvexPolygon& target)
    : source_(source), target_(target), target_edges_(indices_of(edges_of(target))) {}

void Rims::add_blocker(const std::vector<RimEdge>& edges) {
    blocker_edges_.push_back(indices_of(edges));
}

std::vector<std::uint32_t> Rims::indices_of(const std::vector<RimEdge>& edges) {
    std::vector<std::uint32_t> result;
    for (const RimEdge& edge : edges) {
        const double room = 1e-24 * (edge.b - edge.a).squaredNorm();
        const auto is_near = [&](const Vector3d& x, const Vector3d& y) { return (x - y).squaredNorm() <= room; };
        const auto same = std::find_if(edges_.begin(), edges_.end(), [&](const RimEdge& other) {
            return (is_near(edge.a, other.a) && is_near(edge.b, other.b)) ||
                   (is_near(edge.a, other.b) && is_near(edge.b, other.a));
        });
        result.push_back(static_cast<std::uint32_t>(same - edges_.begin()));
        if (same == edges_.end()) edges_.push_back(edge);
    }
    return result;
}

/// The edge is as long as the angle that it subtends, and moves by at most the inverse of its distance per length.
double Rims::slope_of(const PartExtent& part, const RimEdge& edge, double most_angle) const {
    const double nearest = distance(part.centre, edge.a, edge.b);
    const double away = nearest - part.radius;
    if (!(away > 0)) return HUGE_VAL;
    const Vector3d a = edge.a - part.centre;
    const Vector3d b = edge.b - part.centre;
    double cosine = 1;
    if (is_flat(source_.shape)) {
        const double height = std::max(source_.normal.dot(a), source_.normal.dot(b));
        if (!(height > 0)) return 0;
        cosine = std::min(height / away, 1.0);
    }
    const double length = (b - a).norm();
    const double across = a.cross(b).norm();
    double sum = length / (nearest * nearest);  // the integral of 1 / r^2 along the edge
    if (across > 0) sum = std::min(sum, std::atan2(across, a.dot(b)) * length / across);
    sum *= (nearest / away) * (nearest / away);
    return std::min(sum, most_angle / away) * cosine / pi;
}

/// Between two directions to the target from one place of the part.
double Rims::widest_angle(const PartExtent& part) const {
    const double away = distance(part.centre, target_, twice_area(target_)) - part.radius;
    if (!(away > 0)) return pi;
    double widest = 0;
    for (const Vector3d& a : target_) {
        for (const Vector3d& b : target_) widest = std::max(widest, (a - b).norm());
    }
    return std::min(pi, widest / away);
}

double Rims::slope(const PartExtent& part, std::span<const std::uint32_t> blockers) const {
    double slope = 0;
    for (const std::uint32_t edge : target_edges_) slope += slope_of(part, edges_[edge], pi);
    // An edge of a blocker counts where it stands before the target, which it crosses in a straight line.
    const double most_angle = widest_angle(part);
    const std::vector<Vector3d> cone = cone_of(part, target_);
    const auto is_beside = [&](const RimEdge& edge) {
        return std::any_of(cone.begin(), cone.end(), [&](const Vector3d& normal) {
            return std::min(normal.dot(edge.a - part.centre), normal.dot(edge.b - part.centre)) > part.radius;
        });
    };
    std::vector<std::uint32_t> counted = target_edges_;
    for (const std::uint32_t blocker : blockers) {
        for (const std::uint32_t index : blocker_edges_[blocker]) {
            if (std::find(counted.begin(), counted.end(), index) != counted.end()) continue;
            counted.push_back(index);
            if (!is_beside(edges_[index])) slope += slope_of(part, edges_[index], most_angle);
        }
    }
    return slope;
}

PartBounds::Polygon::Polygon(ConvexPolygon polygon)
    : corners(std::move(polygon)), normal(twice_area(corners)), area(normal.norm() / 2) {}

/// Parts below the horizon of a flat source neither send nor hide anything.
ConvexPolygon PartBounds::above_horizon(const Surface& surface, const Vector3d& origin) const {
    ConvexPolygon result = corners(surface.shape);
    for (Vector3d& corner : result) corner -= origin;
    if (!is_flat(source_.shape)) return result;
    return clipped(result, source_.normal, extent(source_, source_.normal).high - source_.normal.dot(origin));
}

PartBounds::PartBounds(const Surface& source, const BlockedPair& pair, const std::vector<RimEdge>& rim,
                       std::size_t blockers)
    : source_(source), is_plane_(true), target_(pair.target), rims_(source_, target_.corners) {
    std::vector<std::vector<RimEdge>> edges(blockers);
    for (const RimEdge& edge : rim) edges[pair.indices[edge.blocker]].push_back(edge);
    for (const std::vector<RimEdge>& of_blocker : edges) rims_.add_blocker(of_blocker);
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
    return std::min(1.0, polygon.area / (pi * away * away) * cosine(height) * cosine(over_polygon));
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
