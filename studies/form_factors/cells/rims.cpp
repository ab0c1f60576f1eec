#include "studies/form_factors/cells/rims.hpp"

#include "core/geometry/surface_map.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

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

Rims::Rims(const Surface& source, const ConvexPolygon& target)
    : source_(source), target_(target), target_edges_(indices_of(edges_of(target))) {}

std::vector<Rims::Edge> edges_of(const ConvexPolygon& polygon) {
    std::vector<Rims::Edge> result;
    for (std::size_t k = 0; k < polygon.size(); ++k) result.push_back({polygon[k], next_corner(polygon, k)});
    return result;
}

void Rims::add_blocker(const std::vector<Edge>& edges) {
    blocker_edges_.push_back(indices_of(edges));
}

std::vector<std::uint32_t> Rims::indices_of(const std::vector<Edge>& edges) {
    std::vector<std::uint32_t> result;
    for (const Edge& edge : edges) {
        const double room = 1e-12 * (edge.b - edge.a).norm();
        const auto is_near = [&](const Vector3d& x, const Vector3d& y) { return (x - y).norm() <= room; };
        const auto same = std::find_if(edges_.begin(), edges_.end(), [&](const Edge& other) {
            return (is_near(edge.a, other.a) && is_near(edge.b, other.b)) ||
                   (is_near(edge.a, other.b) && is_near(edge.b, other.a));
        });
        result.push_back(static_cast<std::uint32_t>(same - edges_.begin()));
        if (same == edges_.end()) edges_.push_back(edge);
    }
    return result;
}

/// The edge is as long as the angle that it subtends, and moves by at most the inverse of its distance per length.
double Rims::slope_of(const PartExtent& part, const Edge& edge, double most_angle) const {
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
    const auto is_beside = [&](const Edge& edge) {
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

}  // namespace ff::studies::form_factors
